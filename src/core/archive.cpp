#include "core/archive.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/fnv.hpp"
#include "core/world.hpp"

namespace sunder::core {

static_assert(std::endian::native == std::endian::little);

void Archive::section(std::string_view what) {
    section_ = what;
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(what.data(), what.size())));
    const auto mark = static_cast<std::uint32_t>(hash.value());
    whole(mark, mark, mark);
}

std::span<const std::byte> Archive::take(std::size_t count) {
    require(count <= from_.size());
    const std::span<const std::byte> taken = from_.first(count);
    from_ = from_.subspan(count);
    return taken;
}

void Archive::refuse() const {
    throw InputError("the saved state cannot be restored: its " + section_ +
                     " cannot be so in this world; save it again");
}

template <std::floating_point Number>
void archiveCells(Archive& a, const World& world, State& state) {
    std::vector<Number> numbers;
    const auto vectors = [&](std::vector<Vec3>& field) {
        for (const Vec3& vector : field)
            for (const double x : vector) numbers.push_back(static_cast<Number>(x));
        a.reals(std::span(numbers));
        std::size_t next = 0;
        for (Vec3& vector : field)
            for (double& x : vector) x = static_cast<double>(numbers[next++]);
        numbers.clear();
    };
    a.section("nodes");
    vectors(state.displacement);
    vectors(state.velocity);
    a.section("bonds");
    for (int bond = 0; bond < world.bondSlots(); ++bond) {
        if (!isBond(world, bond)) continue;
        double &damage = state.damage[bond], &slow = state.slow[bond];
        damage = static_cast<double>(a.real(static_cast<Number>(damage), Number{0}, Number{1}));
        slow = static_cast<double>(a.real(static_cast<Number>(slow)));
    }
    if (world.cellsBreak())
        for (double& stress : state.slowStress)
            stress = static_cast<double>(a.real(static_cast<Number>(stress)));
}

template void archiveCells<float>(Archive&, const World&, State&);
template void archiveCells<double>(Archive&, const World&, State&);

void archiveBodies(Archive& a, const World& world, std::vector<int>& absent,
                   std::vector<int>& released) {
    a.section("bodies");
    for (std::vector<int>* list : {&absent, &released}) {
        std::vector<int> got;
        for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body)
            if (a.flag(std::binary_search(list->begin(), list->end(), body))) got.push_back(body);
        *list = std::move(got);
    }
}

bool isBond(const World& world, int bond) {
    const int cell = bond / kBondsPerCell;
    return world.present(cell) && world.neighbour(cell, bond % kBondsPerCell, +1) >= 0;
}

int archiveBond(Archive& a, const World& world, int now) {
    const int bond = a.whole(now, 0, world.bondSlots() - 1);
    a.require(a.writes() || isBond(world, bond));
    return bond;
}

void archive(Archive& a, const World& world, Event& event) {
    event.body = a.whole(event.body, kEveryBody, static_cast<int>(world.bodies().size()) - 1);
    for (float& x : event.point) x = a.real(x);
    event.radius = a.real(event.radius, 0.f);
    event.acceleration = a.vector(event.acceleration);
    event.outward = a.real(event.outward);
    event.falloff = a.flag(event.falloff);
    event.start = a.real(event.start, 0., 1e17);  // steps: no event begins later
    event.end = a.real(event.end, event.start, 1e18);
}

void archive(Archive& a, ObjectState& state) {
    state.present = a.flag(state.present);
    state.position = a.vector(state.position);
    for (double& x : state.orientation.coeffs()) x = a.real(x, -2., 2.);
    const double length = state.orientation.norm();
    a.require(a.writes() || (length > 0.5 && length < 2));  // 1, but for rounding
    state.velocity = a.vector(state.velocity);
    state.angularMomentum = a.vector(state.angularMomentum);
    state.load = a.real(state.load, 0.);
}

}  // namespace sunder::core
