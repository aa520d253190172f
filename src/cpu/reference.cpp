#include "cpu/reference.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/archive.hpp"
#include "core/links.hpp"
#include "core/tetrahedra.hpp"

namespace sunder::cpu {

using namespace core;

/// The nodes as objects see them.
class ReferenceSolver::ObjectCells : public Objects::Cells {
  public:
    explicit ObjectCells(ReferenceSolver& solver) : solver_(solver) {}

    Bounds bounds(int body) const override {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Bounds bounds{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
        const Body& of = solver_.world_.bodies()[body];
        for (int cell = of.firstCell; cell < of.firstCell + of.cellCount(); ++cell) {
            if (!solver_.world_.present(cell)) continue;
            const CellMotion nodes = motion(cell);
            for (int corner = 0; corner < kCorners; ++corner) {
                const Vec3& x = nodes.position[corner];
                const double speed = nodes.velocity[corner].norm();
                const Vec3 way =
                    Vec3::Constant(contactMargin(0, 0, speed, solver_.world_.contactTime()));
                bounds.low = bounds.low.cwiseMin(x - way);
                bounds.high = bounds.high.cwiseMax(x + way);
            }
        }
        return bounds;
    }
    CellMotion motion(int cell) const override {
        CellMotion motion;
        for (int corner = 0; corner < kCorners; ++corner) {
            const int node = kCorners * cell + corner;
            motion.position[corner] =
                solver_.world_.restPosition(node) + solver_.state_.displacement[node];
            motion.velocity[corner] = solver_.state_.velocity[node];
        }
        return motion;
    }
    std::uint8_t links(int cell, int corner) const override {
        return solver_.links_[kCorners * cell + corner];
    }
    void push(int cell, const std::array<double, kCorners>& weights, const Vec3& force) override {
        for (int corner = 0; corner < kCorners; ++corner)
            solver_.force_[kCorners * cell + corner] += weights[corner] * force;
    }

  private:
    ReferenceSolver& solver_;
};

ReferenceSolver::ReferenceSolver(const World& world)
    : world_(world), barriers_(barriers(world.description())) {
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        for (int t = 0; t < kTetrahedraPerCell; ++t) {
            Element element{};
            Mat3 rest;
            const Tetrahedron& tet = kTetrahedra[world.parity(cell)][t];
            for (int i = 0; i < 4; ++i) element.nodes[i] = kCorners * cell + tet[i];
            for (int i = 0; i < 3; ++i)
                rest.col(i) =
                    world.cornerOffset(cell, tet[i + 1]) - world.cornerOffset(cell, tet[0]);
            element.inverseRest = rest.inverse();
            element.volume = rest.determinant() / 6;
            element.cell = cell;
            element.apex = t < 4 ? tet[0] : -1;
            elements_.push_back(element);
        }
    }
    force_.resize(world.nodeCount());
    eventAcceleration_.resize(world.nodeCount());
    links_.resize(world.nodeCount());
    cellStress_.resize(world.cellCount());
    principal_.resize(world.cellCount());
    if (world.description().contact) contact_.emplace(world);
    if (!world.objects().empty()) objects_.emplace(world);
    setState(world.initialState());
}

State ReferenceSolver::state() const {
    State state = state_;
    std::erase_if(state.pushes, [this](const Event& old) { return old.hasEnded(state_.step); });
    if (objects_) state.objects = objects_->states();
    return state;
}

void ReferenceSolver::setState(const State& state) {
    state_ = state;
    if (objects_) objects_->set(state.objects);
    updateLinks();
    searchDue_ = true;
    if (watch_) watch_->forget();
}

void ReferenceSolver::archive(Archive& a) {
    a.section("step");
    State now = state();
    now.step = a.step(state_.step);
    a.section("pushes");
    a.list(now.pushes, kMaxPushes, [&](Event& event) { core::archive(a, world_, event); });
    archiveBodies(a, world_, now.absent, now.released);
    archiveCells<double>(a, world_, now);
    IncidentWatch::archive(a, world_, watch_.get());
    a.section("searches");
    const bool searchDue = a.flag(searchDue_);
    if (contact_) contact_->archive(a);
    if (objects_) objects_->archive(a);
    if (!a.reads()) return;
    state_ = std::move(now);
    updateLinks();
    searchDue_ = searchDue;
}

void ReferenceSolver::push(const Event& event) {
    std::erase_if(state_.pushes, [this](const Event& old) { return old.hasEnded(state_.step); });
    state_.pushes.push_back(event);
}

void ReferenceSolver::putObject(int object, const ObjectState& state) {
    objects_->set(object, state);
}

void ReferenceSolver::setPresent(int body, bool present) {
    if (this->present(body) == present) return;
    world_.setPresent(state_, body, present);
    updateLinks();
    searchDue_ = true;
}

void ReferenceSolver::releaseAnchors(int body) {
    world_.releaseAnchors(state_, body);
}

void ReferenceSolver::setIncidents(IncidentRing* ring) {
    watch_ = ring ? std::make_unique<IncidentWatch>(world_, *ring) : nullptr;
    if (objects_) objects_->setWatch(watch_.get());
}

void ReferenceSolver::advance(int steps) {
    for (int i = 0; i < steps; ++i) {
        const bool fracture = state_.step % world_.fractureInterval() == 0;
        if (contact_ && (searchDue_ || state_.step % world_.contactInterval() == 0))
            contact_->search(state_, links_);
        updateElements(fracture);
        if (contact_) contact_->addForces(state_, freeNodes(), force_, watch_.get());
        if (objects_) pushObjects();
        searchDue_ = false;
        updateNodes();
        if (objects_) objects_->move();
        if (fracture) updateFracture();
        ++state_.step;
        if (watch_ && watch_->due(state_.step)) lookForIncidents();
    }
}

void ReferenceSolver::lookForIncidents() {
    watch_->look(state_.step, [this](int node) -> Vec3 {
        return world_.restPosition(node) + state_.displacement[node];
    });
}

ReferenceSolver::Deformation ReferenceSolver::deformationOf(const Element& e) const {
    Mat3 displacement, velocity;
    for (int i = 0; i < 3; ++i) {
        displacement.col(i) = state_.displacement[e.nodes[i + 1]] - state_.displacement[e.nodes[0]];
        velocity.col(i) = state_.velocity[e.nodes[i + 1]] - state_.velocity[e.nodes[0]];
    }
    // Derivatives by the body's own coordinates at rest: its axes are what F is there.
    const Mat3& axes = world_.bodies()[world_.bodyOf(e.cell)].axes;
    return {axes + displacement * e.inverseRest, velocity * e.inverseRest};
}

/// Forces of every tetrahedron on its own copies of its corners: −V·P·∇N, turned back.
void ReferenceSolver::updateElements(bool fracture) {
    std::fill(force_.begin(), force_.end(), Vec3::Zero());
    if (fracture)
        std::fill(principal_.begin(), principal_.end(), -std::numeric_limits<double>::infinity());
    Mat3 back = Mat3::Identity();
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        const Element& e = elements_[i];
        if (!world_.present(e.cell, state_)) continue;
        const ElementLaw& law = world_.laws()[world_.lawOf(e.cell)];
        if (i % kTetrahedraPerCell == 0) {
            const Deformation central = deformationOf(elements_[i + kTetrahedraPerCell - 1]);
            back = turnedBack(law, central.F, central.rate, world_.step());
        }
        const auto [F, rate] = deformationOf(e);
        const ElementStress stress =
            elementStress(law, world_.materialOf(e.cell).law, F, rate, world_.step());
        const Mat3 forces = -e.volume * back * stress.piola * e.inverseRest.transpose();
        for (int k = 0; k < 3; ++k) force_[e.nodes[k + 1]] += forces.col(k);
        force_[e.nodes[0]] -= forces.rowwise().sum();
        if (!fracture) continue;
        principal_[e.cell] =
            std::max(principal_[e.cell], largestPrincipalStress(law, F, stress.piola));
        if (e.apex >= 0) {
            const Mat3 biot = stress.rotation.transpose() * stress.piola;
            cellStress_[e.cell][e.apex / 2] = 0.5 * (biot + biot.transpose());
        }
    }
}

ReferenceSolver::NodeGroup ReferenceSolver::groupOf(int node) const {
    NodeGroup group;
    // The same order for every copy of the lattice point.
    for (int octant = 0; octant < 8; ++octant) {
        if (!(links_[node] >> octant & 1)) continue;
        const int cell = cellInOctant(world_, node / kCorners, node % kCorners, octant);
        const int member = kCorners * cell + (octant ^ 7);
        group.force += force_[member];
        group.mass += world_.nodeMass(member);
        group.anchored |= world_.anchored(member, state_);
        if (contact_) group.listed += contact_->listed()[cell];
    }
    return group;
}

/// What nodes would do without contact, where that matters to it.
std::vector<ReferenceContact::FreeNode> ReferenceSolver::freeNodes() const {
    std::vector<ReferenceContact::FreeNode> nodes;
    if (!world_.unequalCells()) return nodes;
    nodes.resize(static_cast<std::size_t>(world_.nodeCount()));
    for (int node = 0; node < world_.nodeCount(); ++node) {
        const int cell = node / kCorners;
        if (!world_.present(cell, state_)) continue;
        const NodeGroup group = groupOf(node);
        if (group.anchored) continue;
        const Vec3& gravity = world_.bodies()[world_.bodyOf(cell)].gravity;
        nodes[node] = {group.force / group.mass + gravity, group.listed / (kCorners * group.mass)};
    }
    return nodes;
}

void ReferenceSolver::pushObjects() {
    ObjectCells cells(*this);
    objects_->startStep(state_.step);
    if (const std::vector<Blast> now = blasts(); !now.empty()) objects_->accelerate(now);
    if (searchDue_ || objects_->searchDue() || state_.step % world_.contactInterval() == 0) {
        std::vector<bool> there(world_.bodies().size(), true);
        for (const int body : state_.absent) there[body] = false;
        objects_->search(cells, there);
    }
    objects_->push(cells);
}

std::vector<Blast> ReferenceSolver::blasts() const {
    std::vector<Blast> result;
    const auto add = [&](const Event& event) {
        const double weight = event.weight(state_.step);
        if (event.body == kEveryBody && weight > 0) result.push_back({&event, weight});
    };
    std::for_each(world_.events().begin(), world_.events().end(), add);
    std::for_each(state_.pushes.begin(), state_.pushes.end(), add);
    return result;
}

void ReferenceSolver::addEvent(const Event& event) {
    const double weight = event.weight(state_.step);
    if (weight == 0) return;
    int first = 0, end = world_.cellCount();
    if (event.body != kEveryBody) {
        const Body& body = world_.bodies()[event.body];
        first = body.firstCell;
        end = first + body.cellCount();
    }
    for (int node = kCorners * first; node < kCorners * end; ++node) {
        const Vec3 rest = world_.restPosition(node);
        if (event.body == kEveryBody)
            eventAcceleration_[node] +=
                weight * event.accelerationAt(rest + state_.displacement[node]);
        else if (insidePatch(event, rest.cast<float>()))
            eventAcceleration_[node] += weight * event.acceleration;
    }
}

/// Symplectic Euler on joined groups, then the barriers.
void ReferenceSolver::updateNodes() {
    const double h = world_.step();
    std::fill(eventAcceleration_.begin(), eventAcceleration_.end(), Vec3::Zero());
    for (const Event& event : world_.events()) addEvent(event);
    for (const Event& event : state_.pushes) addEvent(event);
    for (int node = 0; node < world_.nodeCount(); ++node) {
        const int cell = node / kCorners;
        if (!world_.present(cell, state_)) continue;
        const NodeGroup group = groupOf(node);
        Vec3 &u = state_.displacement[node], &v = state_.velocity[node];
        if (group.anchored) {
            v.setZero();
            continue;
        }
        const Body& body = world_.bodies()[world_.bodyOf(cell)];
        v = v * std::exp(-body.drag * h) +
            h * (group.force / group.mass + body.gravity + eventAcceleration_[node]);
        Vec3 next = u + h * v;
        const Vec3 rest = world_.restPosition(node);
        for (const Barrier& barrier : barriers_) {
            const int axis = barrier.axis;
            const double bound = barrier.place - rest[axis];
            const double depth = barrier.side * (bound - u[axis]);
            const double after = Barrier::depthAfter(depth, world_.pushSpeed(), h);
            if (barrier.distance(rest + next) >= -after) continue;
            v = barrier.stopped(v);
            u[axis] = bound - barrier.side * after;
            next = u + h * v;
            v[axis] += barrier.side * (std::max(0.0, depth) - after) / h;
        }
        u = next;
    }
}

void ReferenceSolver::updateFracture() {
    const std::vector<double> before = state_.damage;
    breakCells();
    damageBonds();
    if (state_.damage == before) return;
    updateLinks();
    if (!watch_) return;
    for (int bond = 0; bond < world_.bondSlots(); ++bond)
        if (before[bond] < 1 && state_.damage[bond] >= 1) watch_->broke(bond);
}

/// Whether a cell's largest principal stress, its dynamic part scaled by S, is more than it bears;
/// also advances the slow part.
bool ReferenceSolver::overstressed(int cell) {
    const ElementLaw& law = world_.laws()[world_.lawOf(cell)];
    if (!std::isfinite(law.maxStress)) return false;
    if (law.stressScale == 1) return principal_[cell] > law.maxStress;
    double& slow = state_.slowStress[cell];
    const double unscaled = principal_[cell] / law.stressScale;
    const bool over = slow + law.stressScale * std::max(0.0, unscaled - slow) > law.maxStress;
    slow += (std::max(0.0, unscaled) - slow) * slowShare(world_);
    return over;
}

/// `fracture = "cell"` (thesis, chapter 7): an overstressed cell leaves all its neighbours.
void ReferenceSolver::breakCells() {
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        if (!world_.present(cell, state_) || !overstressed(cell)) continue;
        for (int axis = 0; axis < 3; ++axis)
            for (const int owner : {cell, world_.neighbour(cell, axis, -1)})
                if (owner >= 0) {
                    double& damage = state_.damage[kBondsPerCell * owner + axis];
                    damage = std::max(damage, 1.0);
                }
    }
}

/// Traction on the face between a cell and its neighbour along `axis`; also advances the bond's
/// slow part.
ReferenceSolver::Load ReferenceSolver::loadOf(int cell, int axis, const ElementLaw& law) {
    const int other = world_.neighbour(cell, axis, +1);
    const double unscaled =
        equivalentTraction(world_, cell, axis, cellStress_[cell], cellStress_[other]);
    double& slow = state_.slow[kBondsPerCell * cell + axis];
    slow += (unscaled - slow) * slowShare(world_);
    const double blow = std::max(0.0, unscaled - slow);
    return {slow + law.stressScale * blow, blow};
}

void ReferenceSolver::damageBonds() {
    const double interval = world_.fractureInterval() * world_.step();
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        if (!world_.present(cell, state_)) continue;
        const ElementLaw& law = world_.laws()[world_.lawOf(cell)];
        for (int axis = 0; axis < 3; ++axis) {
            const int bond = kBondsPerCell * cell + axis;
            double& damage = state_.damage[bond];
            const double strength = world_.bondStrength(bond);
            if (damage >= 1 || !std::isfinite(strength)) continue;
            const Load load = loadOf(cell, axis, law);
            const double ratio = load.equivalent / strength;
            if (ratio > 1)
                damage =
                    std::min(1.0, damage + interval / law.damageTime * std::min(ratio - 1, 4.0));
            const double real = law.stressScale * law.stressScale * load.blow;
            if (load.blow > law.suddenTraction && real > kSuddenStress * strength) damage = 1;
        }
    }
}

void ReferenceSolver::updateLinks() {
    for (int node = 0; node < world_.nodeCount(); ++node)
        links_[node] = linkMask(heldBonds(world_, state_, node / kCorners, node % kCorners),
                                (node % kCorners) ^ 7);
}

}  // namespace sunder::cpu
