// What GatherSolver knows: states, saved states, bodies that come from another solver.
#include <utility>

#include "core/archive.hpp"
#include "gpu/body_ranges.hpp"
#include "gpu/gather.hpp"

namespace sunder::gpu {

using namespace core;

template <class NodeLayer, class BondLayer>
void GatherSolver::readLayers(TexelRange cells, State& state, const NodeLayer& nodes,
                              const BondLayer& bonds) const {
    const int count = cells.end - cells.first;
    for (int corner = 0; corner < kCorners; ++corner) {
        const auto u = nodes(2 * corner), v = nodes(2 * corner + 1);
        for (int i = 0; i < count; ++i) {
            const int node = kCorners * (cells.first + i) + corner;
            state.displacement[node] = {u[i].x, u[i].y, u[i].z};
            state.velocity[node] = {v[i].x, v[i].y, v[i].z};
        }
    }
    const auto damage = bonds(0), slow = bonds(1);
    for (int i = 0; i < count; ++i) {
        state.slowStress[cells.first + i] = slow[i].w;
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            const int bond = kBondsPerCell * (cells.first + i) + axis;
            state.damage[bond] = damage[i][axis];
            state.slow[bond] = slow[i][axis];
        }
    }
}

State GatherSolver::outline() const {
    State state = world_.initialState();
    state.step = step_;
    state.pushes = events_.schedule().added(step_);
    book_.describe(state);
    return state;
}

State GatherSolver::state() const {
    State state = outline();
    read({0, world_.cellCount()}, state);
    if (objects_) objects_->read(state);
    return state;
}

class GatherSolver::LateState : public StateCopy {
  public:
    explicit LateState(const GatherSolver& solver)
        : solver_(solver),
          cells_(kLayers * solver.nodes_[0].layerBytes(), nullptr, GL_STREAM_READ, "late cells") {}
    void start() override {
        outline_ = solver_.outline();
        std::size_t offset = 0;
        const auto copy = [&](const TexelTarget& from, int layers) {
            for (int layer = 0; layer < layers; ++layer, offset += from.layerBytes())
                from.copy(layer, cells_, offset);
        };
        copy(solver_.nodes_[solver_.currentNodes_], kNodeLayers);
        copy(solver_.bonds_[solver_.currentBonds_], kBondTexels);
        if (solver_.objects_) solver_.objects_->copy(objects_);
        done_ = gl::Fence::insert();
        glFlush();
    }
    State take() override {
        done_.wait();
        State state = outline_;
        std::vector<vec4> texels(cells_.size() / sizeof(vec4));
        cells_.read(0, cells_.size(), texels.data());
        const TexelTarget& nodes = solver_.nodes_[0];
        const auto at = [&](int layer) {
            return texels.data() + static_cast<std::size_t>(layer) * nodes.layerTexels();
        };
        solver_.readLayers(
            {0, solver_.world_.cellCount()}, state, [&](int layer) { return at(layer); },
            [&](int layer) { return at(kNodeLayers + layer); });
        if (solver_.objects_) solver_.objects_->read(objects_, state);
        return state;
    }

  private:
    static constexpr int kNodeLayers = 2 * kCorners, kLayers = kNodeLayers + kBondTexels;
    const GatherSolver& solver_;
    State outline_;
    gl::Buffer cells_, objects_;
    gl::Fence done_;
};

std::unique_ptr<StateCopy> GatherSolver::makeStateCopy() const {
    return std::make_unique<LateState>(*this);
}

void GatherSolver::setState(const State& state) {
    step_ = state.step;
    events_.schedule().setAdded(state.pushes);
    if (incidents_) {
        incidents_->finish();
        incidents_->forget();
    }
    book_.follow(state);
    bookChanged();
    write({0, world_.cellCount()}, state);
    for (const int body : state.absent) writeBoth(cellsOf(world_, body), state);
    book_.wakeAll();
    showObjects(state);
    for (int body = 0; body < bodyCount(); ++body)
        if (holds(body)) changed(body);
    bodiesChanged();
    bindInputs();
    writeLinks(awake_);
}

void GatherSolver::archive(Archive& a) {
    a.section("step");
    const std::int64_t step = a.step(step_);
    events_.schedule().archive(a, step);
    const std::vector<bool> active = book_.archiveBodies(a);
    if (a.reads()) bookChanged();
    archiveCells(a);
    book_.archiveSleepers(a, active);
    monitor_.archive(a);
    archiveLooks(a);
    if (a.reads()) {
        step_ = step;
        follow();
    }
    if (contact_) contact_->archive(a);
    if (objects_) objects_->archive(a, [this](int object) { return book_.objectAsleep(object); });
    if (a.reads() && incidents_) {
        incidents_->finish();
        incidents_->forget();
        bonds_[currentBonds_].copy(0, incidents_->known());
    }
    IncidentPass::archive(a, world_, incidents_ ? &*incidents_ : nullptr);
}

/// Both halves of the ping-pong get the same: what sleeps is to be the same in both, and what is
/// awake is written before it is read.
void GatherSolver::archiveCells(Archive& a) {
    const TexelRange every{0, world_.cellCount()};
    const auto count = static_cast<std::size_t>(every.end);
    std::vector<vec4> first(count), second(count);
    std::vector<float> numbers(7 * count);
    const auto readBoth = [&](const TexelTarget& from, int layer) {
        if (!a.writes()) return;
        first = from.read(layer, every);
        second = from.read(layer + 1, every);
    };
    const auto writeBoth = [&](std::array<TexelTarget, 2>& to, int layer) {
        for (TexelTarget& half : to) {
            half.write(layer, 0, first);
            half.write(layer + 1, 0, second);
        }
    };
    a.section("nodes");
    for (int corner = 0; corner < kCorners; ++corner) {
        readBoth(nodes_[currentNodes_], 2 * corner);
        for (std::size_t i = 0; i < count; ++i) {
            float* to = &numbers[7 * i];
            for (int axis = 0; axis < 3; ++axis) to[axis] = first[i][axis];
            for (int k = 0; k < 4; ++k) to[3 + k] = second[i][k];
        }
        a.reals(std::span(numbers));
        if (!a.reads()) continue;
        for (std::size_t i = 0; i < count; ++i) {
            const float* from = &numbers[7 * i];
            const int node = kCorners * static_cast<int>(i) + corner;
            first[i] = {from[0], from[1], from[2],
                        static_cast<float>(world_.restPosition(node)[1])};
            second[i] = {from[3], from[4], from[5], from[6]};
        }
        writeBoth(nodes_, 2 * corner);
    }
    a.section("bonds");
    readBoth(bonds_[currentBonds_], 0);
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            float& damage = first[i][axis];
            if (isBond(world_, kBondsPerCell * static_cast<int>(i) + axis))
                damage = a.real(damage, 0.f, 1.f);
            else
                damage = static_cast<float>(kNoBond);
        }
        first[i].w = a.flag(first[i].w > 0) ? 1.f : 0.f;
        if (a.reads() && !present(world_.bodyOf(static_cast<int>(i)))) first[i].w = SUNDER_GONE;
        for (int k = 0; k < 4; ++k) second[i][k] = a.real(second[i][k]);
    }
    if (a.reads()) writeBoth(bonds_, 0);
}

void GatherSolver::archiveLooks(Archive& a) {
    a.section("looks");
    const bool newNodeWatch = a.flag(newNodeWatch_), newBondWatch = a.flag(newBondWatch_),
               stirred = a.flag(stirred_);
    const auto dropped = a.whole<std::int64_t>(droppedContacts_, 0, Archive::kLastStep);
    std::vector<double> haste = contactHaste_;
    a.list(haste, world_.bodies().size(), [&](double& x) { x = a.real(x, 0.); });
    if (!a.reads()) return;
    newNodeWatch_ = newNodeWatch;
    newBondWatch_ = newBondWatch;
    stirred_ = stirred;
    droppedContacts_ = dropped;
    contactHaste_ = std::move(haste);
}

void GatherSolver::writeBoth(TexelRange cells, const State& state) {
    for (int half = 0; half < 2; ++half) {
        write(cells, state);
        currentNodes_ = 1 - currentNodes_;
        currentBonds_ = 1 - currentBonds_;
    }
}

void GatherSolver::follow() {
    bodiesChanged();
    bindInputs();
    const TexelRange every{0, world_.cellCount()};
    CellSet cells(stage_, 1, "all cells");
    cells.set({&every, 1}, columns_);
    writeLinks(cells);
}

void GatherSolver::adopt(const std::vector<int>& bodies, const State& state) {
    std::vector<int> there;
    for (const int body : bodies)
        if (present(body)) there.push_back(body);
    const std::vector<TexelRange> cells = rangesOf(world_, there);
    for (const TexelRange& range : cells) write(range, state);
    if (objects_) {
        State now;
        objects_->read(now);
        for (int object = 0; object < objectCount(); ++object) {
            if (now.objects[object] == state.objects[object]) continue;
            wake(memberOfObject(world_, object));
            objects_->put(object, state.objects[object], step_);
        }
    }
    for (const int body : bodies) {
        wake(memberOfBody(body));
        book_.setHeld(body, true);
        changed(body);
    }
    bodiesChanged();
    if (cells.empty()) return;
    CellSet adopted(stage_, cells.size(), "adopted cells");
    adopted.set(cells, columns_);
    bindInputs();
    writeLinks(adopted);
}

void GatherSolver::release(const std::vector<int>& bodies, State& state) {
    for (const TexelRange& range : rangesOf(world_, bodies)) read(range, state);
    if (objects_) objects_->read(state);
    for (const int body : bodies) {
        wake(memberOfBody(body));
        book_.setHeld(body, false);
    }
    bodiesChanged();
}

void GatherSolver::show(int body, const State& state) {
    write(cellsOf(world_, body), state);
}

void GatherSolver::showObjects(const State& state) {
    if (objects_) objects_->set(state);
}

void GatherSolver::write(TexelRange cells, const State& state) {
    std::vector<vec4> u(static_cast<std::size_t>(cells.end - cells.first)), v = u, damage = u,
                                                                            slow = u;
    for (int corner = 0; corner < kCorners; ++corner) {
        for (std::size_t i = 0; i < u.size(); ++i) {
            const int node = kCorners * (cells.first + static_cast<int>(i)) + corner;
            u[i] = toVec4(state.displacement[node], world_.restPosition(node)[1]);
            v[i] = toVec4(state.velocity[node], 0);
        }
        nodes_[currentNodes_].write(2 * corner, cells.first, u);
        nodes_[currentNodes_].write(2 * corner + 1, cells.first, v);
    }
    for (std::size_t i = 0; i < damage.size(); ++i) {
        const bool there = present(world_.bodyOf(cells.first + static_cast<int>(i)));
        damage[i].w = there ? 0.f : static_cast<float>(SUNDER_GONE);
        slow[i].w = static_cast<float>(state.slowStress[cells.first + static_cast<int>(i)]);
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            const int bond = kBondsPerCell * (cells.first + static_cast<int>(i)) + axis;
            damage[i][axis] = static_cast<float>(state.damage[bond]);
            slow[i][axis] = static_cast<float>(state.slow[bond]);
        }
    }
    bonds_[currentBonds_].write(0, cells.first, damage);
    bonds_[currentBonds_].write(1, cells.first, slow);
    if (incidents_)
        incidents_->known().write(cells.first * sizeof(vec4), damage.size() * sizeof(vec4),
                                  damage.data());
}

void GatherSolver::read(TexelRange cells, State& state) const {
    readLayers(
        cells, state, [&](int layer) { return nodes_[currentNodes_].read(layer, cells); },
        [&](int layer) { return bonds_[currentBonds_].read(layer, cells); });
}

}  // namespace sunder::gpu
