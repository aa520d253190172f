#include "cpu/relaxation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/diagnostics.hpp"
#include "core/elasticity.hpp"
#include "core/limits.hpp"
#include "core/sleep.hpp"
#include "core/traction.hpp"
#include "cpu/cpu_solver.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// Steps from one look at the kinetic energy to the next: a fraction of the fastest swing.
constexpr int kLook = 2;
/// Steps from one look for what topples to the next.
constexpr int kTopplingLook = 256;
/// Share of a strength that S times what its stress still changes by may amount to.
constexpr double kStillStress = 0.01;
/// Share of the largest displacement by which displacements may still change.
constexpr double kStillShape = 0.002;
/// The same for what touches something, in parts of the speed at which it may fall asleep: friction
/// that grows with the speed of sliding lets heaps creep for good.
constexpr double kCreep = 0.2;
/// A swing that takes more than twice as long as the longest before is creep if its energy is below
/// this share of the highest.
constexpr double kCreepEnergy = 0.01;
/// Damping of what is no faster than rounding makes it, over the longest swing: 0.7 of critical for
/// what swings to its equilibrium in that time.
constexpr double kCalming = 0.7 * std::numbers::pi;
/// Edges by which things may move as a whole, aside or in turning.
constexpr double kFarthest = 0.5;

/// A group without the rest of the world; nothing in it breaks or is pushed. Bodies and free
/// objects in the group's order, then objects that do not move.
WorldDescription alone(const World& world, const StandingGroup& group) {
    const WorldDescription& from = world.description();
    WorldDescription copy = from;
    copy.events.clear();
    copy.throws.clear();
    copy.bodies.clear();
    copy.objects.clear();
    for (Material& material : copy.materials) {
        material.fracture = FractureMode::None;
        material.damping = 0;
    }
    for (const int body : group.bodies) copy.bodies.push_back(from.bodies[body]);
    for (const int object : group.objects) copy.objects.push_back(from.objects[object]);
    for (const ObjectDescription& object : from.objects) {
        if (!object.position || !(object.unyielding() || object.hungFrom)) continue;
        copy.objects.push_back(object);
        copy.objects.back().fixed = true;
        copy.objects.back().kinematic = false;
        copy.objects.back().hungFrom.reset();
        copy.objects.back().velocity.setZero();
        copy.objects.back().spin.setZero();
    }
    copy.contact = from.contact && copy.bodies.size() + copy.objects.size() > 1;
    return copy;
}

/// How many times as stiff a cell might be with this step.
double stiffnessReserve(const World& world, int cell) {
    const ElementLaw& law = world.laws()[world.lawOf(cell)];
    const Material& material = world.materialOf(cell);
    return stableYoungModulus(material.density, law.cellSize.minCoeff(), material.poissonRatio,
                              world.step()) /
           law.youngModulus;
}

double largestOf(const std::vector<Vec3>& displacement) {
    double largest = 0;
    for (const Vec3& u : displacement) largest = std::max(largest, u.squaredNorm());
    return std::sqrt(largest);
}

/// J: what nodes move with for rounding alone, found by letting beams and walls at rest go on. F is
/// near 1 and rounded; with the stiffness that the step just carries, mean speeds are those of 1.5
/// to 2.5 roundings of an edge per step, with less stiffness less. And displacements are rounded.
double noiseEnergy(const World& world, const std::vector<Vec3>& displacement) {
    constexpr double kRounding = 6e-8;
    const double largest = largestOf(displacement);
    double energy = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        const double edge = world.laws()[world.lawOf(cell)].cellSize.minCoeff();
        const double perStep =
            kRounding * std::max(4 * edge / stiffnessReserve(world, cell), 2 * largest);
        const double speed = perStep / world.step();
        energy += 0.5 * world.cellMass(cell) * speed * speed;
    }
    return energy;
}

/// Whether some element is so strongly deformed that its stress at rest depends on the step
/// (core/elasticity.hpp).
bool isHot(const World& world, const std::vector<int>& bodies, const State& state) {
    for (const int index : bodies) {
        const Body& body = world.bodies()[index];
        for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
            if (!world.present(cell)) continue;
            for (const Mat3& F : cellGradients(world, cell, state.displacement, 1))
                if (F.determinant() < hotDeterminant(1) || F.squaredNorm() > 6) return true;
        }
    }
    return false;
}

Vec3 across(const Vec3& x, const Vec3& direction) {
    return x - x.dot(direction) / std::max(direction.squaredNorm(), 1e-300) * direction;
}

/// m: how far one of a body's nodes has come with the body as a whole, by shifting across gravity
/// and by turning. (Sagging moves its centre along gravity, and is no toppling.)
double farthestShift(const World& world, const std::vector<Vec3>& displacement, const Body& body) {
    const int first = kCorners * body.firstCell, end = first + kCorners * body.cellCount();
    Vec3 centre = Vec3::Zero(), shift = Vec3::Zero();
    double mass = 0;
    for (int node = first; node < end; ++node) {
        const double m = world.nodeMass(node);
        centre += m * world.restPosition(node);
        shift += m * displacement[node];
        mass += m;
    }
    centre /= mass;
    shift /= mass;
    Mat3 spread = Mat3::Zero();
    for (int node = first; node < end; ++node) {
        const Vec3 arm = world.restPosition(node) - centre;
        spread += world.nodeMass(node) * (arm + displacement[node] - shift) * arm.transpose();
    }
    const Mat3 turn = polarRotation(spread) - Mat3::Identity();
    const Vec3 aside = across(shift, body.gravity);
    double farthest = 0;
    for (int node = first; node < end; ++node)
        if (world.nodeMass(node) > 0)
            farthest =
                std::max(farthest, (aside + turn * (world.restPosition(node) - centre)).norm());
    return farthest;
}

/// The same for an object.
double farthestShift(const World& world, const ObjectDescription& object, const ObjectState& now) {
    const double angle = now.orientation.angularDistance(object.orientation);
    return across(now.position - *object.position, world.description().gravity).norm() +
           angle * object.halfSize.maxCoeff();
}

}  // namespace

/// Advances a copy and stops it where its kinetic energy has passed a maximum.
class Relaxation::Damping {
  public:
    Damping(const World& copy, const Shape& from, const Threads& threads)
        : copy_(copy), solver_(copy, threads) {
        state_ = copy.initialState();
        if (!from.displacement.empty()) {
            state_.displacement = from.displacement;
            state_.objects = from.objects;
            solver_.setState(state_);
        }
        startWindow(from);
    }

    Shape shape() {
        for (int body = 0; body < static_cast<int>(copy_.bodies().size()); ++body)
            solver_.store(body, state_);
        solver_.storeObjects(state_);
        return {state_.displacement, state_.objects};
    }

    void advance() {
        solver_.advance(kLook);
        swing_ += kLook;
        window_ += kLook;
        const double last = std::exchange(energy_, solver_.kineticEnergy());
        peak_ = std::max(peak_, energy_);
        stopped_ = energy_ <= last && (peak_ > noise_ || swing_ >= longest_);
        if (stopped_) longest_ = std::max(longest_, swing_);
        const bool creeps =
            longest_ > 0 && swing_ > 2 * longest_ && energy_ < kCreepEnergy * highest_;
        stopped_ |= creeps;
        if (stopped_)
            stop();
        else if (longest_ > 0 && peak_ <= noise_)
            // What rounding stirs up has maxima too. Stopped at each of them, slow swings would
            // never get anywhere.
            solver_.scaleVelocities(std::exp(-kCalming * kLook / longest_));
    }

    /// It stands still, and as many steps were gone since startWindow() as the slowest swing took:
    /// small fast ones come between, and only then can be seen what is left of it.
    bool windowOver() const { return stopped_ && window_ >= longest_; }
    int windowSteps() const { return window_; }
    /// Whether nothing but rounding moved within the window.
    bool calm() const { return highestInWindow_ <= noise_; }
    void startWindow(const Shape& now) {
        window_ = 0;
        highestInWindow_ = 0;
        noise_ = noiseEnergy(copy_, now.displacement);
    }

  private:
    void stop() {
        solver_.scaleVelocities(0);
        highest_ = std::max(highest_, peak_);
        highestInWindow_ = std::max(highestInWindow_, peak_);
        energy_ = peak_ = 0;
        swing_ = 0;
    }

    const World& copy_;
    CpuSolver solver_;
    State state_;
    double noise_ = 0;                                                  ///< J
    double energy_ = 0, peak_ = 0, highest_ = 0, highestInWindow_ = 0;  ///< J
    int swing_ = 0, longest_ = 0, window_ = 0;                          ///< steps
    bool stopped_ = false;
};

Relaxation::Relaxation(const World& world, const StandingGroup& group, const Threads& threads)
    : world_(world), group_(group), threads_(threads), alone_(alone(world, group)) {}

Relaxation::Outcome Relaxation::run(State& state, int steps,
                                    const std::function<void(double)>& progress) {
    stepsLeft_ = steps_ = steps;
    progress_ = progress;
    if (const double stretch = stepStretch(); stretch > 1.5) {
        // In steps as long as the stiffness allows.
        WorldDescription longSteps = alone_;
        longSteps.step *= stretch;
        // No material may have less than 1 Pa; the step limits it as before.
        for (const ElementLaw& law : world_.laws())
            longSteps.materials[law.material].youngModulus = std::max(law.youngModulus, 1.0);
        const Outcome outcome = relax(World(longSteps), state);
        if (outcome != Outcome::Rest || !isHot(world_, group_.bodies, state)) return outcome;
    }
    return relax(World(alone_), state);
}

/// How many times as long steps may be. Contact has a stiffness that depends on them.
double Relaxation::stepStretch() const {
    if (alone_.contact || alone_.bodies.size() > 1) return 1;
    const Body& body = world_.bodies()[group_.bodies[0]];
    double reserve = std::numeric_limits<double>::infinity();
    for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell)
        if (world_.present(cell)) reserve = std::min(reserve, stiffnessReserve(world_, cell));
    return std::min(0.999 * std::sqrt(reserve), kMaxStep / world_.step());
}

Relaxation::Outcome Relaxation::relax(const World& copy, State& state) {
    Damping damping(copy, reached_, threads_);
    bool compare = false;
    while (stepsLeft_ >= kLook) {
        damping.advance();
        stepsLeft_ -= kLook;
        if (progress_) progress_(1 - static_cast<double>(stepsLeft_) / steps_);
        const bool over = damping.windowOver();
        if (!over && stepsLeft_ % kTopplingLook >= kLook) continue;
        Shape now = damping.shape();
        if (topples(copy, now)) return Outcome::Toppled;
        if (!over) continue;
        const bool still =
            compare && (damping.calm() || keepsShape(copy, reached_, now, damping.windowSteps()));
        if (still && keepsStress(now, state)) return Outcome::Rest;
        damping.startWindow(now);
        reached_ = std::move(now);
        compare = true;
    }
    if (compare) keepsStress(reached_, state);
    return Outcome::OutOfSteps;
}

bool Relaxation::topples(const World& copy, const Shape& now) {
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) {
        const Body& body = copy.bodies()[i];
        if (isAnchored(copy, static_cast<int>(i))) continue;
        const double shift = farthestShift(copy, now.displacement, body);
        if (!(shift <= kFarthest * body.cellSize.minCoeff()))  // nor not a number
            toppled_.bodies.push_back(group_.bodies[i]);
    }
    for (std::size_t i = 0; i < group_.objects.size(); ++i) {
        const ObjectDescription& object = alone_.objects[i];
        const double shift = farthestShift(copy, object, now.objects[i]);
        if (!(shift <= kFarthest * 2 * object.halfSize.minCoeff()))
            toppled_.objects.push_back(group_.objects[i]);
    }
    return !toppled_.bodies.empty() || !toppled_.objects.empty();
}

bool Relaxation::keepsShape(const World& copy, const Shape& before, const Shape& now,
                            int steps) const {
    const double largest = largestOf(now.displacement);
    for (const Body& body : copy.bodies()) {
        const double creep =
            alone_.contact ? kCreep * creepSpeed(copy, body) * steps * copy.step() : 0;
        const double allowed = std::max(kStillShape * largest, creep);
        for (int node = kCorners * body.firstCell;
             node < kCorners * (body.firstCell + body.cellCount()); ++node)
            if (!((now.displacement[node] - before.displacement[node]).norm() <= allowed))
                return false;
    }
    return true;
}

/// Writes `now` into the state; whether the stresses there were the same.
bool Relaxation::keepsStress(const Shape& now, State& state) const {
    write(now, state);
    bool same = true;
    for (const int index : group_.bodies) {
        const Body& body = world_.bodies()[index];
        const auto bonds = state.slow.begin() + kBondsPerCell * body.firstCell;
        const auto cells = state.slowStress.begin() + body.firstCell;
        const std::vector<double> tractions(bonds, bonds + kBondsPerCell * body.cellCount());
        const std::vector<double> stresses(cells, cells + body.cellCount());
        makeStressesSlow(world_, index, state);
        for (int i = 0; i < body.cellCount(); ++i) {
            const int cell = body.firstCell + i;
            if (!world_.present(cell)) continue;
            const ElementLaw& law = world_.laws()[world_.lawOf(cell)];
            const auto compare = [&](double before, double after, double strength) {
                const double change = law.stressScale * std::abs(after - before);
                same &= change == 0 || change <= kStillStress * strength;
            };
            compare(stresses[i], cells[i], law.maxStress);
            for (int bond = kBondsPerCell * i; bond < kBondsPerCell * (i + 1); ++bond)
                compare(tractions[bond], bonds[bond],
                        world_.bondStrength(kBondsPerCell * body.firstCell + bond));
        }
    }
    return same;
}

void Relaxation::write(const Shape& now, State& state) const {
    auto from = now.displacement.begin();
    for (const int index : group_.bodies) {
        const Body& body = world_.bodies()[index];
        const std::ptrdiff_t nodes = kCorners * body.cellCount();
        std::copy_n(from, nodes, state.displacement.begin() + kCorners * body.firstCell);
        from += nodes;
    }
    for (std::size_t i = 0; i < group_.objects.size(); ++i) {
        ObjectState& object = state.objects[group_.objects[i]];
        object = now.objects[i];
        object.velocity.setZero();
        object.angularMomentum.setZero();
    }
}

}  // namespace sunder::cpu
