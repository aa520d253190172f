#include "cpu/cpu_body_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace sunder::cpu {

using namespace core;

namespace {

constexpr int kMostCalmSteps = 1 << 30;

}  // namespace

BodyRun::BodyRun(const World& world, int index, const std::vector<Law>& laws,
                 const EventSchedule& events)
    : world_(world), events_(events), storage_(world, index, laws), news_(kMaxParts) {
    const BodyArrays& a = storage_.arrays();
    for (const Event& event : world.events()) addPatch(event, 0);
    ofWorld_ = patches_.size();
    reach_ = (a.reach + kLanes - 1) / kLanes;
    setReleased(false);
    sleepSteps_ = sunder::core::sleepSteps(world);
}

void BodyRun::addPatch(const Event& event, std::int64_t now) {
    const BodyArrays& a = storage_.arrays();
    const Body& body = world_.bodies()[a.index];
    if (event.body != a.index) return;
    const auto later = patches_.begin() + static_cast<std::ptrdiff_t>(ofWorld_);
    patches_.erase(std::remove_if(later, patches_.end(),
                                  [&](const Patch& old) { return old.event.hasEnded(now); }),
                   patches_.end());
    Patch patch{event, std::vector<std::uint8_t>(static_cast<std::size_t>(a.stride))};
    for (int node = kCorners * body.firstCell; node < kCorners * (body.firstCell + a.cells);
         ++node) {
        const Vec3 rest = world_.restPosition(node);
        if (!insidePatch(event, rest.cast<float>())) continue;
        const IVec3 c = body.coordinates(node / kCorners);
        auto& bits = patch.corners[a.place(c[0], c[1], c[2])];
        bits = static_cast<std::uint8_t>(bits | 1 << node % kCorners);
    }
    patches_.push_back(std::move(patch));
}

void BodyRun::setAddedPatches(const std::vector<Event>& events, std::int64_t now) {
    patches_.resize(ofWorld_);
    for (const Event& event : events) addPatch(event, now);
}

std::size_t BodyRun::bytes() const {
    std::size_t sum = storage_.bytes() + sizeof *this + news_.size() * sizeof news_[0];
    for (const Patch& patch : patches_) sum += patch.corners.size();
    return sum;
}

bool BodyRun::startStep(std::int64_t step) {
    const BodyArrays& body = storage_.arrays();
    check_ = step % world_.fractureInterval() == 0;
    fracture_ = check_ && (body.bondsBreak || body.cellsBreak);
    gatherPushes(step);
    gatherBlasts(step);
    if (!pushes_.empty() || !blasts_.empty()) asleep_ = false;
    return !asleep_;
}

void BodyRun::elements(int first, int end) {
    updateElements(storage_.arrays(), first, end, fracture_);
}

void BodyRun::nodes(int first, int end, int part) {
    moveNodes(first, end, part);
    breakBonds(first, end, part);
}

void BodyRun::breakBonds(int first, int end, int part) {
    if (!fracture_) return;
    const BodyArrays& body = storage_.arrays();
    const auto interval = static_cast<float>(world_.fractureInterval());
    news_[part].bonds = updateBonds(body, first, end, interval * body.step);
}

void BodyRun::endStep() {
    if (!check_) return;
    bool broke = false, calm = pushes_.empty() && blasts_.empty();
    const float limit = touching_ ? creepSpeed2_ : calmSpeed2_;
    for (PartNews& news : news_) {
        broke |= news.bonds.broke;
        calm &= !news.bonds.damaged && news.fastest < limit;
        news = {};
    }
    if (broke) {
        if (listBreaks_) listBroken();
        relinkBroken(world_, storage_.arrays());
        ++relinks_;
    }
    updateSleep(calm);
}

BodyRun::Inner BodyRun::inner(int first, int end) const {
    const int from = first == 0 ? 0 : std::min(end, first + reach_);
    const int to = end == storage_.arrays().vectors ? end : end - reach_;
    return {from, std::max(from, to)};
}

/// Elements of one part, and right behind them its inner nodes: all forces around those are known,
/// and their state and forces still lie in the cache. (A cell's state is read by the cell alone, so
/// it may change as soon as its own elements are done.)
void BodyRun::sweep(int first, int end, int part) {
    constexpr int block = 8;
    const auto [from, to] = inner(first, end);
    int done = from;
    for (int begin = first; begin < end; begin += block) {
        const int next = std::min(begin + block, end);
        updateElements(storage_.arrays(), begin, next, fracture_);
        const int ready = next == end ? to : std::min(to, next - reach_);
        if (ready <= done) continue;
        moveNodes(done, ready, part);
        done = ready;
    }
}

/// The nodes that waited for the neighbouring parts.
void BodyRun::finishNodes(int first, int end, int part) {
    const auto [from, to] = inner(first, end);
    moveNodes(first, from, part);
    moveNodes(to, end, part);
}

void BodyRun::moveNodes(int first, int end, int part) {
    if (first == end) return;
    if (!blasts_.empty()) addBlasts(first, end);
    float& fastest = news_[part].fastest;
    fastest = std::max(fastest, updateNodes(storage_.arrays(), first, end, pushes_));
}

void BodyRun::gatherPushes(std::int64_t step) {
    pushes_.clear();
    for (const Patch& patch : patches_) {
        const double weight = patch.event.weight(step);
        if (weight == 0) continue;
        const Eigen::Vector3f a = (weight * patch.event.acceleration).cast<float>();
        pushes_.push_back({patch.corners.data(), {a[0], a[1], a[2]}});
    }
}

void BodyRun::gatherBlasts(std::int64_t step) {
    blasts_ = events_.blastsAt(step);
    if (blasts_.empty()) return;
    const Box box = bounds();
    std::erase_if(blasts_,
                  [&](const Blast& blast) { return !blast.event->reaches(box.low, box.high); });
}

bool BodyRun::blastWithin(std::int64_t from, std::int64_t to) const {
    if (events_.nextBlast(from) >= to) return false;
    const Box box = bounds();
    return events_.blastWithin(from, to, box.low, box.high);
}

Box BodyRun::bounds() const {
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box{Vec3::Constant(far), Vec3::Constant(-far)};
    const int cells = storage_.arrays().cells;
    for (int place = 0; place < cells; ++place) {
        if (rest()[kCorners * place].hasNaN()) continue;
        for (int corner = 0; corner < kCorners; ++corner) {
            const Vec3 x = positionAt(place, corner);
            box.low = box.low.cwiseMin(x);
            box.high = box.high.cwiseMax(x);
        }
    }
    return box;
}

const std::vector<Eigen::Vector3f>& BodyRun::rest() const {
    if (!rest_.empty()) return rest_;
    const BodyArrays& a = storage_.arrays();
    const Body& body = world_.bodies()[a.index];
    rest_.assign(static_cast<std::size_t>(kCorners * a.cells),
                 Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    for (int place = 0; place < a.cells; ++place) {
        const int cell = body.cellAt(a.coordinates(place));
        if (!world_.present(cell)) continue;
        for (int corner = 0; corner < kCorners; ++corner)
            rest_[kCorners * place + corner] =
                world_.restPosition(kCorners * cell + corner).cast<float>();
    }
    return rest_;
}

Vec3 BodyRun::positionAt(int place, int corner) const {
    const BodyArrays& a = storage_.arrays();
    Vec3 position = rest()[kCorners * place + corner].cast<double>();
    for (int axis = 0; axis < 3; ++axis)
        position[axis] += a.displacement[tiled(kNodeComponents, 3 * corner + axis, place)];
    return position;
}

/// Into velocities, just before the nodes move by them: as it would be in the step's acceleration,
/// but for rounding.
void BodyRun::addBlasts(int first, int end) {
    const BodyArrays& a = storage_.arrays();
    const double share = world_.step() / a.drag;  // the step lets velocities fade before it adds
    for (int place = first * kLanes; place < std::min(end * kLanes, a.cells); ++place) {
        if (rest()[kCorners * place].hasNaN()) continue;
        for (int corner = 0; corner < kCorners; ++corner) {
            if (a.inverseMass[tiled(kCorners, corner, place)] == 0) continue;  // anchored
            const Vec3 sum = accelerationAt(positionAt(place, corner), blasts_);
            for (int axis = 0; axis < 3; ++axis)
                a.velocity[tiled(kNodeComponents, 3 * corner + axis, place)] +=
                    static_cast<float>(share * sum[axis]);
        }
    }
}

void BodyRun::listBroken() {
    const BodyArrays& a = storage_.arrays();
    const Body& body = world_.bodies()[a.index];
    for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
        const IVec3 c = body.coordinates(cell);
        const int broke = a.broke[a.place(c[0], c[1], c[2])];
        for (int axis = 0; axis < 3; ++axis)
            if (broke >> axis & 1) broken_.push_back(kBondsPerCell * cell + axis);
    }
}

Vec3 BodyRun::position(int node) const {
    const BodyArrays& a = storage_.arrays();
    const IVec3 c = world_.bodies()[a.index].coordinates(node / kCorners);
    Vec3 position = world_.restPosition(node);
    for (int axis = 0; axis < 3; ++axis)
        position[axis] += a.displacement[tiled(kNodeComponents, 3 * (node % kCorners) + axis,
                                               a.place(c[0], c[1], c[2]))];
    return position;
}

void BodyRun::updateSleep(bool calm) {
    calmSteps_ = calm ? calmSteps_ + world_.fractureInterval() : 0;
    // Where bodies touch, what a whole island does decides (CpuSolver::rest()).
    if (ready() && !world_.description().contact) fallAsleep();
}

void BodyRun::fallAsleep() {
    scaleVelocities(0);
    asleep_ = true;
}

void BodyRun::scaleVelocities(float factor) {
    wake();
    BodyArrays& a = storage_.arrays();
    const std::span<float> all(a.velocity,
                               static_cast<std::size_t>(kNodeComponents * kLanes * a.vectors));
    if (factor == 0)
        std::fill(all.begin(), all.end(), 0.f);  // infinite ones, too
    else
        for (float& v : all) v *= factor;
}

double BodyRun::kineticEnergy(int first, int end) const {
    const BodyArrays& a = storage_.arrays();
    double sum = 0;
    for (int tile = first; tile < end; ++tile) {
        const float* v = a.velocity + tiled(kNodeComponents, 0, tile * kLanes);
        float squares[kLanes] = {};
        for (int component = 0; component < kNodeComponents; ++component)
            for (int lane = 0; lane < kLanes; ++lane)
                squares[lane] += v[component * kLanes + lane] * v[component * kLanes + lane];
        for (int lane = 0; lane < kLanes; ++lane) {
            const Law& law = a.lawIndex ? a.laws[a.lawIndex[tile * kLanes + lane]] : a.law;
            sum += 0.5f * law.nodeMass * squares[lane];
        }
    }
    return sum;
}

void BodyRun::addRestBoxes(std::vector<RestBox>& boxes) const {
    const int index = storage_.arrays().index;
    const Body& body = world_.bodies()[index];
    const Vec3 reach = Vec3::Constant(restReach(body));
    for (int first = body.firstCell; first < body.firstCell + body.cellCount();
         first += kCellsPerRestBox) {
        constexpr double far = std::numeric_limits<double>::infinity();
        RestBox box{memberOfBody(index), Vec3::Constant(far), Vec3::Constant(-far)};
        const int end = std::min(first + kCellsPerRestBox, body.firstCell + body.cellCount());
        for (int node = kCorners * first; node < kCorners * end; ++node) {
            if (!world_.present(node / kCorners)) continue;
            const Vec3 place = position(node);
            box.low = box.low.cwiseMin(place - reach);
            box.high = box.high.cwiseMax(place + reach);
        }
        if (box.low[0] <= box.high[0]) boxes.push_back(box);
    }
}

/// Calls move(mine, theirs) for every number of the body and its place in `state`.
template <class AnyState, class Move>
void BodyRun::exchange(AnyState& state, const Move& move) const {
    const BodyArrays& a = storage_.arrays();
    const Body& body = world_.bodies()[a.index];
    for (int cell = 0; cell < a.cells; ++cell) {
        const IVec3 c = body.coordinates(body.firstCell + cell);
        const int i = a.place(c[0], c[1], c[2]);
        for (int corner = 0; corner < kCorners; ++corner)
            for (int axis = 0; axis < 3; ++axis) {
                const int node = kCorners * (body.firstCell + cell) + corner;
                const std::ptrdiff_t at = tiled(kNodeComponents, 3 * corner + axis, i);
                move(a.displacement[at], state.displacement[node][axis]);
                move(a.velocity[at], state.velocity[node][axis]);
            }
        if (a.slowStress) move(a.slowStress[i], state.slowStress[body.firstCell + cell]);
        for (int axis = 0; axis < 3; ++axis) {
            const int bond = kBondsPerCell * (body.firstCell + cell) + axis;
            move(a.damage[axis * a.stride + i], state.damage[bond]);
            move(a.slow[axis * a.stride + i], state.slow[bond]);
        }
    }
}

void BodyRun::setReleased(bool released) {
    storage_.arrays().released = released;
    const Body& body = world_.bodies()[storage_.arrays().index];
    const double calm = calmSpeed(world_, body, released),
                 creep = creepSpeed(world_, body, released);
    calmSpeed2_ = static_cast<float>(calm * calm);
    creepSpeed2_ = static_cast<float>(creep * creep);
}

void BodyRun::relink() {
    relinkAll(world_, storage_.arrays());
    ++relinks_;
}

void BodyRun::load(const State& state) {
    exchange(state, [](float& mine, double theirs) { mine = static_cast<float>(theirs); });
    relink();
    asleep_ = touching_ = false;
    calmSteps_ = 0;
    broken_.clear();
}

void BodyRun::store(State& state) const {
    exchange(state, [](float mine, double& theirs) { theirs = mine; });
}

/// Tiles as they are, with their padding, whose speed counts, too, where a room pushes it.
void BodyRun::archive(Archive& a, bool listed) {
    BodyArrays& body = storage_.arrays();
    const auto cells = static_cast<std::size_t>(body.cells),
               components = static_cast<std::size_t>(kNodeComponents * kLanes * body.vectors);
    a.section("nodes");
    a.reals(std::span(body.displacement, components));
    a.reals(std::span(body.velocity, components));
    a.section("bonds");
    for (int axis = 0; axis < kBondsPerCell; ++axis) {
        float* damage = body.damage + axis * body.stride;
        for (std::size_t i = 0; i < cells; ++i) {
            if (damage[i] == static_cast<float>(kNoBond)) continue;
            const float got = a.real(damage[i], 0.f, 1.f);
            if (a.reads()) damage[i] = got;
        }
        a.reals(std::span(body.slow + axis * body.stride, cells));
    }
    if (body.slowStress) a.reals(std::span(body.slowStress, cells));
    a.section("sleep");
    const bool asleep = a.flag(asleep_);
    const int calmSteps = a.whole(calmSteps_, 0, kMostCalmSteps);
    float fastest = 0;  // since the last check
    for (const PartNews& news : news_) fastest = std::max(fastest, news.fastest);
    fastest = a.real(fastest, 0.f);
    std::vector<int> broken = broken_;
    if (listed) {
        const Body& of = world_.bodies()[body.index];
        a.list(broken, static_cast<std::size_t>(world_.bondSlots()), [&](int& bond) {
            bond = archiveBond(a, world_, bond);
            a.require(of.firstCell <= bond / kBondsPerCell &&
                      bond / kBondsPerCell < of.firstCell + of.cellCount());
        });
    }
    if (!a.reads()) return;
    relink();
    asleep_ = asleep;
    calmSteps_ = calmSteps;
    touching_ = false;
    std::fill(news_.begin(), news_.end(), PartNews{});
    news_.front().fastest = fastest;
    broken_.clear();
    if (listed && listBreaks_) broken_ = std::move(broken);
}

}  // namespace sunder::cpu
