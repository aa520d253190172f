#include "cpu/cpu_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <tuple>

#include "core/contact.hpp"
#include "core/elasticity.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

constexpr std::size_t kAlignment = 64;

std::ptrdiff_t roundUp(std::ptrdiff_t n, std::ptrdiff_t to) {
    return (n + to - 1) / to * to;
}

}  // namespace

std::vector<Law> makeLaws(const World& world) {
    std::vector<Law> result;
    for (const ElementLaw& from : world.laws()) {
        const Material& m = world.description().materials[from.material];
        Law law{};
        law.lambda = static_cast<float>(from.lambda);
        law.twoMu = static_cast<float>(2 * from.mu);
        law.corotated = m.law == ConstitutiveLaw::Corotated ? 1.f : 0.f;
        law.stressScale = static_cast<float>(from.stressScale);
        law.damageRate = static_cast<float>(1 / from.damageTime);
        law.shearWeight = static_cast<float>(m.shearWeight);
        law.friction = static_cast<float>(m.internalFriction);
        law.maxStress = static_cast<float>(std::min<double>(from.maxStress, kUnbreakable));
        law.suddenTraction =
            static_cast<float>(std::min<double>(from.suddenTraction, kUnbreakable));
        law.hotStress = from.hotViscosity > 0
                            ? 1.f
                            : static_cast<float>((1 + 2 * kDamping) / (1 + 2 * kHotDamping));
        law.hotDeterminant = static_cast<float>(hotDeterminant(from.hotViscosity));
        law.hotRate = static_cast<float>(from.hotViscosity / (kDamping * world.step()));
        law.nodeMass = static_cast<float>(m.density * from.cellSize.prod() / kCorners);
        law.largestStress = static_cast<float>(from.largestStress);
        result.push_back(law);
    }
    return result;
}

void BodyStorage::Free::operator()(std::byte* memory) const {
    ::operator delete[](memory, std::align_val_t{kAlignment});
}

BodyStorage::BodyStorage(const World& world, int body, const std::vector<Law>& laws) {
    arrays_.index = body;
    arrays_.laws = laws.data();
    choose(world);
    allocate();
    fill(world);
}

/// Order of the cells, constants of the body, and which arrays it needs.
void BodyStorage::choose(const World& world) {
    BodyArrays& a = arrays_;
    const Body& body = world.bodies()[a.index];
    for (int axis = 0; axis < 3; ++axis) a.extent[axis] = body.cells[axis];
    const bool zSlowest = body.cells[2] > body.cells[1];
    a.steps[0] = 1;
    a.steps[1] = zSlowest ? body.cells[0] : body.cells[0] * body.cells[2];
    a.steps[2] = zSlowest ? body.cells[0] * body.cells[1] : body.cells[0];
    for (int axis = 0; axis < 3; ++axis) a.reach += a.extent[axis] > 1 ? a.steps[axis] : 0;
    a.cells = body.cellCount();
    a.vectors = static_cast<int>(roundUp(a.cells, kLanes) / kLanes);

    int first = -1;
    a.kind = LawKind::Green;
    for (int cell = body.firstCell; cell < body.firstCell + a.cells; ++cell) {
        const int law = world.lawOf(cell);
        if (law < 0) continue;
        if (first < 0) first = law;
        if (law != first) a.kind = LawKind::Mixed;
        const double modulus = world.laws()[law].lambda + 2 * world.laws()[law].mu;
        a.stiff &= modulus > world.materialOf(cell).density * kStiffWaveSpeed * kStiffWaveSpeed;
        a.bondsBreak |= world.materialOf(cell).fracture == FractureMode::Bond;
        const bool cellBreaks = world.materialOf(cell).fracture == FractureMode::Cell;
        a.cellsBreak |= cellBreaks;
        a.stressLost |= cellBreaks && world.laws()[law].limited;
    }
    a.law = a.laws[first];
    if (a.kind != LawKind::Mixed && a.law.corotated != 0) a.kind = LawKind::Corotated;

    a.turned = body.turned;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 3; ++i) a.axes[axis][i] = static_cast<float>(body.axes(i, axis));

    const double h = world.step();
    for (int axis = 0; axis < 3; ++axis) {
        a.inverseCell[axis] = static_cast<float>(1 / body.cellSize[axis]);
        a.forceWeight[axis] = static_cast<float>(body.cellSize.prod() / (6 * body.cellSize[axis]));
        a.gravity[axis] = static_cast<float>(body.gravity[axis]);
    }
    a.dampingTime = static_cast<float>(kDamping * h);
    a.step = static_cast<float>(h);
    a.drag = static_cast<float>(std::exp(-body.drag * h));
    a.slowShare = std::min(1.f, static_cast<float>(world.fractureInterval()) * a.step / 0.1f);
    a.returnShare = static_cast<float>(h / std::max(kPartingTime, h));
    a.returnWay = static_cast<float>(h * world.pushSpeed());
    a.ground = world.description().ground;
    a.groundFriction = static_cast<float>(world.description().groundFriction);
    if (const auto& room = world.description().room) {
        a.room = true;
        a.roomFriction = static_cast<float>(room->friction);
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const float ceiling = room->ceiling ? static_cast<float>(*room->ceiling) : infinity;
        const auto place = [](double wall) { return static_cast<float>(wall); };
        for (const auto& [axis, low, high] : {std::tuple{0, place(room->x[0]), place(room->x[1])},
                                              {1, -infinity, ceiling},
                                              {2, place(room->z[0]), place(room->z[1])}}) {
            a.roomLow[axis] = low;
            a.roomHigh[axis] = high;
        }
    }
}

/// One block for all arrays. Each is a whole number of cache lines, and not a multiple of four: at
/// a power of two all the arrays that a step runs through would fall into the same few sets of the
/// cache.
void BodyStorage::allocate() {
    BodyArrays& a = arrays_;
    // Neighbours are read before it is known whether they are there.
    const std::ptrdiff_t pad = roundUp(a.reach, kLanes);
    a.stride = roundUp(a.cells, kLanes) + pad;
    if (a.stride / kLanes % 4 == 0) a.stride += kLanes;
    const auto floats = [&](int arrays) { return static_cast<std::size_t>(arrays * a.stride) * 4; };
    const auto tiles = [&](int components) {
        return static_cast<std::size_t>(roundUp(a.vectors * components * kLanes, kAlignment));
    };
    const std::size_t margin = static_cast<std::size_t>(pad) * 4;

    std::byte* start = nullptr;
    const auto take = [&](auto*& array, std::size_t size, bool wanted = true) {
        if (!wanted) return;
        if (start)
            array = reinterpret_cast<std::remove_reference_t<decltype(array)>>(start + bytes_);
        bytes_ += size;
    };
    const auto layOut = [&] {
        take(a.displacement, 4 * tiles(kNodeComponents));
        take(a.velocity, 4 * tiles(kNodeComponents));
        bytes_ += margin;
        take(a.force, floats(kNodeComponents));
        bytes_ += margin;
        take(a.stress, floats(24) + margin, a.bondsBreak);
        take(a.over, floats(1) + margin, a.cellsBreak);
        take(a.damage, floats(3));
        take(a.slow, floats(3));
        take(a.slowStress, floats(1), a.stressLost);
        take(a.strength, floats(3));
        take(a.side, floats(1));
        take(a.inverseMass, 4 * tiles(kCorners));
        for (const int axis : {0, 1, 2})
            take(a.rest[axis], floats(2), a.room || (axis == 1 && a.ground));
        take(a.lawIndex, floats(1), a.kind == LawKind::Mixed);
        take(a.links, tiles(kCorners));
        take(a.broke, static_cast<std::size_t>(roundUp(a.stride, kAlignment)));
    };
    layOut();  // how much it is, then where
    memory_.reset(static_cast<std::byte*>(::operator new[](bytes_, std::align_val_t{kAlignment})));
    start = memory_.get();
    std::memset(start, 0, bytes_);
    bytes_ = 0;
    layOut();
}

void BodyStorage::fill(const World& world) {
    BodyArrays& a = arrays_;
    const Body& body = world.bodies()[a.index];
    std::fill_n(a.side, a.stride, 1.f);
    for (int cell = body.firstCell; cell < body.firstCell + a.cells; ++cell) {
        const IVec3 c = body.coordinates(cell);
        const int i = a.place(c[0], c[1], c[2]);
        a.side[i] = world.parity(cell) ? -1.f : 1.f;
        for (int axis = 0; axis < 3; ++axis)
            for (int upper = 0; a.rest[axis] && upper < 2; ++upper)
                a.rest[axis][upper * a.stride + i] =
                    static_cast<float>(world.restPosition(kCorners * cell + (upper << axis))[axis]);
        if (a.lawIndex) a.lawIndex[i] = std::max(0, world.lawOf(cell));
        for (int axis = 0; axis < 3; ++axis)
            a.strength[axis * a.stride + i] =
                std::min(world.bondStrength(kBondsPerCell * cell + axis), kUnbreakable);
    }
    a.memberCount = 0;
    for (int corner = 0; corner < kCorners; ++corner) {
        const int own = corner ^ 7;
        int count = 0;
        for (int octant = 0; octant < 8; ++octant) {
            std::ptrdiff_t offset = 3 * (octant ^ 7) * a.stride;
            bool possible = true;
            for (int axis = 0; axis < 3; ++axis) {
                const int move = (octant >> axis & 1) - (own >> axis & 1);
                offset += move * a.steps[axis];
                possible &= move == 0 || a.extent[axis] > 1;
            }
            if (possible) a.members[corner][count++] = {1u << octant, offset};
        }
        a.memberCount = count;
    }
}

}  // namespace sunder::cpu
