#include "cpu/cpu_solver.hpp"

#include <algorithm>

#include "core/archive.hpp"
#include "core/incident.hpp"
#include "cpu/cpu_runner.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// A stretch of fewer vectors is not worth a thread of its own.
constexpr int kVectorsPerPart = 16;

}  // namespace

CpuSolver::CpuSolver(const World& world, const Threads& threads)
    : world_(world), events_(world), runner_(std::make_unique<Runner>(threads)) {
    Runner& runner = *runner_;
    runner.laws = cpu::makeLaws(world);
    for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body)
        bodies_.push_back(std::make_unique<BodyRun>(world, body, runner.laws, events_));
    runner.touching.assign(bodies_.size(), false);
    if (world.description().contact) {
        std::vector<const cpu::BodyArrays*> arrays;
        for (const auto& run : bodies_) arrays.push_back(&run->arrays());
        runner.contact.emplace(world, arrays);
        runner.rest.emplace(memberOfObject(world, static_cast<int>(world.objects().size())));
        // Searches come at multiples of kContactInterval.
        runner.restInterval =
            kContactInterval * std::max(1, stepsPerLook(world) / kContactInterval);
        if (!world.objects().empty()) {
            runner.objects.emplace(world);
            runner.objectCells.emplace(world, std::move(arrays), *runner.contact);
        }
    }
    shareOut();
    setState(world.initialState());
}

void CpuSolver::shareOut() {
    Runner& runner = *runner_;
    runner.split.clear();
    runner.whole.clear();
    int cells = 0;
    for (const auto& run : bodies_) cells += run->active() ? run->cells() : 0;
    // A body is split when one thread alone would still be at it after the others were done.
    const int fairShare = cells / (2 * runner.team.size());
    runner.largeCells = std::max(fairShare, 2 * kVectorsPerPart * cpu::kLanes);
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
        const BodyRun& run = *bodies_[body];
        if (!run.active()) continue;
        const bool large = run.cells() > runner.largeCells;
        (runner.team.size() > 1 && large ? runner.split : runner.whole).push_back(body);
    }
    if (runner.contact) runner.contact->forget();
}

CpuSolver::~CpuSolver() = default;

void CpuSolver::advance(int steps) {
    Runner& runner = *runner_;
    const bool holdsAny =
        std::any_of(bodies_.begin(), bodies_.end(), [](const auto& run) { return run->held; });
    runner.team.run([&] {
        if (!runner.contact || !holdsAny) {
            advanceTo(step_ + steps, false);
            return;
        }
        for (const std::int64_t end = step_ + steps; step_ < end;) {
            std::int64_t next = std::min(end, (step_ / kContactInterval + 1) * kContactInterval);
            for (const Throw& thrown : world_.throws())
                if (thrown.step > step_) next = std::min(next, thrown.step);
            startThrows();
            const bool woke = wakePushed(next);
            if (step_ % runner.restInterval == 0) rest();
            if (woke || runner.contact->due() || step_ % kContactInterval == 0 ||
                (runner.objects && runner.objects->searchDue()))
                searchContacts();
            advanceTo(next, true);
        }
    });
}

void CpuSolver::advanceTo(std::int64_t end, bool contact) {
    const IncidentWatch* watch = runner_->watch.get();
    while (step_ < end) {
        const auto count =
            static_cast<int>((watch ? std::min(end, watch->next(step_)) : end) - step_);
        if (runner_->observer) {
            advanceObserved(count, contact);
        } else {
            advanceAlone(count);
            if (contact) advanceTouching(count);
        }
        step_ += count;
        if (watch && watch->due(step_)) lookForIncidents();
    }
}

void CpuSolver::lookForIncidents() {
    IncidentWatch& watch = *runner_->watch;
    for (const auto& run : bodies_) run->takeBreaks([&](int bond) { watch.broke(bond); });
    watch.look(step_, [this](int node) {
        return bodies_[world_.bodyOf(node / kCorners)]->position(node);
    });
}

void CpuSolver::advanceAlone(int steps) {
    const Runner& runner = *runner_;
    const auto alone = [&](int body) {
        if (runner.touching[body]) return;
        bodies_[body]->advance(step_, steps,
                               [](int vectors, const auto& work) { work(0, vectors, 0); });
    };
    const auto together = [&](int body) {
        if (runner.touching[body]) return;
        bodies_[body]->advance(step_, steps, [&](int vectors, const auto& work) {
            const int parts = std::min({cpu::BodyRun::kMaxParts, 4 * runner.team.size(),
                                        std::max(1, vectors / kVectorsPerPart)});
            const auto stretch = [&](int part) {
                work(vectors * part / parts, vectors * (part + 1) / parts, part);
            };
            runner.team.forEach(parts, stretch, true);
        });
    };
    for (const int body : runner.split) together(body);
    runner.team.forEach(static_cast<int>(runner.whole.size()),
                        [&](int i) { alone(runner.whole[i]); });
}

void CpuSolver::advanceTouching(int steps) {
    Runner& runner = *runner_;
    std::vector<const std::vector<int>*> small;
    for (const std::vector<int>& island : runner.islands) {
        int cells = 0;
        for (const int body : island) cells += bodies_[body]->cells();
        if (runner.team.size() > 1 && cells > runner.largeCells)
            advanceLargeIsland(steps, island);
        else
            small.push_back(&island);
    }
    runner.team.forEach(static_cast<int>(small.size()),
                        [&](int i) { advanceIsland(steps, *small[i]); });
}

bool CpuSolver::hasObjects(const std::vector<int>& island) const {
    if (!runner_->objects || &island != &runner_->islands.front()) return false;
    return runner_->objects->anyAwake() ||
           std::any_of(island.begin(), island.end(),
                       [this](int body) { return !bodies_[body]->asleep(); });
}

void CpuSolver::advanceIsland(int steps, const std::vector<int>& bodies) {
    Runner& runner = *runner_;
    cpu::Contact& contact = *runner.contact;
    const bool objects = hasObjects(bodies);
    const auto forAwake = [&](const auto& work) {
        for (const int body : bodies)
            if (!bodies_[body]->asleep()) work(*bodies_[body], body);
    };
    for (std::int64_t step = step_; step < step_ + steps; ++step) {
        for (const int body : bodies) bodies_[body]->startStep(step);
        forAwake([&](BodyRun& run, int body) {
            run.elements(0, run.arrays().vectors);
            if (!contact.wantsFreeMotions()) contact.push(contact.cellsOf(body));
        });
        if (contact.wantsFreeMotions()) {
            forAwake([&](BodyRun&, int body) { contact.findFreeMotions(contact.cellsOf(body)); });
            forAwake([&](BodyRun&, int body) { contact.push(contact.cellsOf(body)); });
        }
        if (objects) runner.objects->push(*runner.objectCells);
        forAwake([&](BodyRun& run, int body) {
            run.nodes(0, run.arrays().vectors, 0);
            run.endStep();
            contact.follow(contact.tilesOf(body));
        });
        if (objects) runner.objects->move();
    }
}

void CpuSolver::advanceLargeIsland(int steps, const std::vector<int>& bodies) {
    struct Part {
        BodyRun* run;
        int first, end, number;
        cpu::Contact::Range tiles, cells;
    };
    Runner& runner = *runner_;
    cpu::Contact& contact = *runner.contact;
    const bool objects = hasObjects(bodies);
    std::vector<Part> parts;
    for (const int body : bodies) {
        BodyRun& run = *bodies_[body];
        const int vectors = run.arrays().vectors;
        const int count = std::clamp(vectors / kVectorsPerPart, 1, cpu::BodyRun::kMaxParts);
        for (int i = 0; i < count; ++i) {
            const int first = vectors * i / count, end = vectors * (i + 1) / count;
            parts.push_back({&run, first, end, i, contact.tilesOf(body, first, end),
                             contact.cellsOf(body, first, end)});
        }
    }
    const auto forAwake = [&](const auto& work) {
        runner.team.forEach(static_cast<int>(parts.size()), [&](int i) {
            if (!parts[i].run->asleep()) work(parts[i]);
        });
    };
    for (std::int64_t step = step_; step < step_ + steps; ++step) {
        for (const int body : bodies) bodies_[body]->startStep(step);
        forAwake([&](const Part& part) {
            part.run->elements(part.first, part.end);
            if (!contact.wantsFreeMotions()) contact.push(part.cells);
        });
        if (contact.wantsFreeMotions()) {
            forAwake([&](const Part& part) { contact.findFreeMotions(part.cells); });
            forAwake([&](const Part& part) { contact.push(part.cells); });
        }
        if (objects) runner.objects->push(*runner.objectCells);
        forAwake([&](const Part& part) {
            part.run->nodes(part.first, part.end, part.number);
            contact.follow(part.tiles);
        });
        for (const int body : bodies)
            if (!bodies_[body]->asleep()) bodies_[body]->endStep();
        if (objects) runner.objects->move();
    }
}

/// Finds what may touch until the next search, and wakes what is hit.
void CpuSolver::searchContacts() {
    Runner& runner = *runner_;
    cpu::Contact& contact = *runner.contact;
    std::vector<cpu::Contact::BodyStatus> status(bodies_.size());
    std::vector<bool> held;
    for (const auto& run : bodies_) held.push_back(run->active());
    for (bool again = true; again;) {
        again = false;
        bool awake = false;
        for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
            const BodyRun& run = *bodies_[body];
            const bool moves = run.active() && !run.asleep();
            status[body] = {run.active(), moves, run.relinks()};
            awake |= moves;
        }
        if (awake)
            contact.search(status, [&](int count, const std::function<void(int)>& work) {
                runner.team.forEach(count, work);
            });
        else
            contact.rest();
        if (runner.objects) runner.objects->search(*runner.objectCells, held);
        for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
            const bool near = runner.objects && runner.objects->near(body);
            const bool hit = bodies_[body]->asleep() && runner.objects && runner.objects->hit(body);
            runner.touching[body] = contact.touching(body) || near;
            bodies_[body]->setTouching(runner.touching[body]);
            if (!(contact.hit(body) && bodies_[body]->asleep()) && !hit) continue;
            wake(memberOfBody(body));
            again = true;
        }
        for (int object = 0; object < static_cast<int>(world_.objects().size()); ++object) {
            if (!runner.objects->disturbed(object)) continue;
            wake(memberOfObject(world_, object));
            again = true;
        }
    }
    findIslands();
}

void CpuSolver::startThrows() {
    Runner& runner = *runner_;
    if (!runner.objects) return;
    for (const Throw& thrown : world_.throws())
        if (thrown.step == step_) wake(memberOfObject(world_, thrown.object));
    runner.objects->startStep(step_);
}

bool CpuSolver::wakePushed(std::int64_t until) {
    bool woke = false;
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
        if (!bodies_[body]->asleep() || !bodies_[body]->pushedWithin(step_, until)) continue;
        wake(memberOfBody(body));
        woke = true;
    }
    return woke;
}

void CpuSolver::wake(int member) {
    for (const int woken : runner_->rest->wake(member))
        if (const int object = woken - memberOfObject(world_, 0); object >= 0)
            runner_->objects->wake(object);
        else
            bodies_[woken]->wake();
}

void CpuSolver::rest() {
    using Status = RestIslands::Status;
    Runner& runner = *runner_;
    if (runner.objects) runner.objects->look(runner.restInterval);
    std::vector<Status> status;
    for (const auto& run : bodies_)
        status.push_back(!run->active()  ? Status::Apart
                         : run->asleep() ? Status::Asleep
                         : run->ready()  ? Status::Ready
                                         : Status::Restless);
    for (int object = 0; object < static_cast<int>(world_.objects().size()); ++object)
        status.push_back(runner.objects->restStatus(object));
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const auto& run : bodies_)
            if (run->active()) run->addRestBoxes(boxes);
    };
    const std::vector<ObjectState> none;
    for (const int member : settleTouching(*runner.rest, world_, status, addBoxes,
                                           runner.objects ? runner.objects->states() : none))
        if (const int object = member - memberOfObject(world_, 0); object >= 0)
            runner.objects->fallAsleep(object);
        else
            bodies_[member]->fallAsleep();
}

void CpuSolver::findIslands() {
    Runner& runner = *runner_;
    runner.islands = runner.contact->islands();
    if (!runner.objects) return;
    const auto near = [&](int body) { return runner.objects->near(body); };
    std::vector<int> together;
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body)
        if (near(body) && !runner.contact->touching(body)) together.push_back(body);
    std::erase_if(runner.islands, [&](const std::vector<int>& island) {
        if (std::none_of(island.begin(), island.end(), near)) return false;
        together.insert(together.end(), island.begin(), island.end());
        return true;
    });
    std::sort(together.begin(), together.end());
    runner.islands.insert(runner.islands.begin(), std::move(together));
}

State CpuSolver::state() const {
    State state = world_.initialState();
    state.step = step_;
    state.pushes = events_.added(step_);
    state.absent = absentBodies();
    for (const auto& run : bodies_)
        if (run->active()) run->store(state);
    storeObjects(state);
    return state;
}

void CpuSolver::push(const Event& event) {
    events_.add(event, step_);
    if (event.body != kEveryBody) bodies_[event.body]->addPatch(event, step_);
}

void CpuSolver::putObject(int object, const ObjectState& state) {
    wake(memberOfObject(world_, object));
    runner_->objects->set(object, state);
}

void CpuSolver::setPresent(int body, bool present) {
    BodyRun& run = *bodies_[body];
    if (run.present == present) return;
    const bool touches = runner_->rest && run.held;
    if (touches && !present) wakeAround(body);
    run.present = present;
    run.load(world_.initialState());
    if (touches && present) wakeAround(body);
    shareOut();
}

bool CpuSolver::present(int body) const {
    return bodies_[body]->present;
}

void CpuSolver::wakeAround(int body) {
    std::vector<RestBox> own, others;
    bodies_[body]->addRestBoxes(own);
    for (int other = 0; other < static_cast<int>(bodies_.size()); ++other)
        if (other != body && asleep(other)) bodies_[other]->addRestBoxes(others);
    for (int object = 0; object < static_cast<int>(world_.objects().size()); ++object)
        if (objectAsleep(object))
            others.push_back(restBoxOf(world_, object, runner_->objects->states()[object]));
    wake(memberOfBody(body));
    for (const int member : membersNear(own, others)) wake(member);
}

std::vector<int> CpuSolver::absentBodies() const {
    std::vector<int> absent;
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body)
        if (!bodies_[body]->present) absent.push_back(body);
    return absent;
}

void CpuSolver::setAbsent(const std::vector<int>& absent) {
    if (absent == absentBodies()) return;
    for (const auto& run : bodies_) run->present = true;
    for (const int body : absent) bodies_[body]->present = false;
    shareOut();
}

void CpuSolver::setState(const State& state) {
    step_ = state.step;
    events_.setAdded(state.pushes);
    setAbsent(state.absent);
    for (const auto& run : bodies_) run->setAddedPatches(state.pushes, step_);
    for (const auto& run : bodies_)
        if (run->held) run->load(state);
    if (runner_->contact) runner_->contact->forget();
    if (runner_->rest) runner_->rest->wakeAll();
    if (runner_->objects) runner_->objects->set(state.objects);
    if (runner_->watch) runner_->watch->forget();
}

void CpuSolver::archive(Archive& a) {
    a.section("step");
    const std::int64_t step = a.step(step_);
    events_.archive(a, step);
    std::vector<int> absent = absentBodies();
    archiveAbsent(a, world_, absent);
    if (a.reads()) setAbsent(absent);
    Runner& runner = *runner_;
    a.section("looks");
    const bool watched = a.flag(runner.watch != nullptr);
    for (const auto& run : bodies_) run->archive(a, watched);
    IncidentWatch::archive(a, world_, runner.watch.get());
    if (a.reads()) {
        step_ = step;
        for (const auto& run : bodies_) run->setAddedPatches(events_.added(step), step);
    }
    if (runner.contact) archiveTouching(a, absent);
}

void CpuSolver::archiveTouching(Archive& a, const std::vector<int>& absent) {
    Runner& runner = *runner_;
    std::vector<bool> held;
    for (const auto& run : bodies_) held.push_back(run->held);
    for (const int body : absent) held[body] = false;
    runner.rest->archive(a, [&](int member) {
        const int object = member - memberOfObject(world_, 0);
        return object < 0 ? held[member] : world_.objects()[object].inverseMass > 0;
    });
    if (a.reads())
        for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
            BodyRun& run = *bodies_[body];
            const bool asleep = runner.rest->asleep(memberOfBody(body));
            if (asleep && !run.asleep()) run.fallAsleep();
            if (!asleep && run.asleep()) run.wake();
        }
    runner.team.run([&] {
        runner.contact->archive(a, held, [&](int count, const std::function<void(int)>& work) {
            runner.team.forEach(count, work);
        });
    });
    if (runner.objects) runner.objects->archive(a);
    if (!a.reads()) return;
    for (int object = 0; object < static_cast<int>(world_.objects().size()); ++object)
        if (runner.rest->asleep(memberOfObject(world_, object))) runner.objects->fallAsleep(object);
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
        runner.touching[body] =
            runner.contact->touching(body) || (runner.objects && runner.objects->near(body));
        bodies_[body]->setTouching(runner.touching[body]);
    }
    findIslands();
}

void CpuSolver::setIncidents(IncidentRing* ring) {
    Runner& runner = *runner_;
    runner.watch = ring ? std::make_unique<IncidentWatch>(world_, *ring) : nullptr;
    for (const auto& run : bodies_) run->listBreaks(ring != nullptr);
    if (runner.contact) runner.contact->setWatch(runner.watch.get());
    if (runner.objects) runner.objects->setWatch(runner.watch.get());
}

void CpuSolver::adopt(const std::vector<int>& bodies, const State& state) {
    for (const int body : bodies) {
        if (runner_->rest) wake(memberOfBody(body));
        if (bodies_[body]->present) bodies_[body]->load(state);
        bodies_[body]->held = true;
    }
    setObjects(state);
    shareOut();
}

void CpuSolver::release(const std::vector<int>& bodies, State& state) {
    for (const int body : bodies) {
        if (runner_->rest) wake(memberOfBody(body));
        bodies_[body]->store(state);
        bodies_[body]->held = false;
    }
    storeObjects(state);
    shareOut();
}

/// Those that are as they were sleep on.
void CpuSolver::setObjects(const State& state) {
    if (!runner_->objects) return;
    Objects& objects = *runner_->objects;
    for (int object = 0; object < static_cast<int>(state.objects.size()); ++object) {
        if (objects.states()[object] == state.objects[object]) continue;
        putObject(object, state.objects[object]);
    }
}

bool CpuSolver::holds(int body) const {
    return bodies_[body]->held;
}

void CpuSolver::store(int body, State& state) const {
    bodies_[body]->store(state);
}

void CpuSolver::storeObjects(State& state) const {
    if (runner_->objects) state.objects = runner_->objects->states();
}

double CpuSolver::kineticEnergy() const {
    struct Part {
        int body, first, end;
        double energy = 0;
    };
    constexpr int kVectors = 256;  // whatever the number of threads: sums are rounded
    std::vector<Part> parts;
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
        const int vectors = bodies_[body]->active() ? bodies_[body]->arrays().vectors : 0;
        for (int first = 0; first < vectors; first += kVectors)
            parts.push_back({body, first, std::min(first + kVectors, vectors)});
    }
    runner_->team.run([&] {
        runner_->team.forEach(static_cast<int>(parts.size()), [&](int i) {
            parts[i].energy = bodies_[parts[i].body]->kineticEnergy(parts[i].first, parts[i].end);
        });
    });
    double sum = 0;
    for (const Part& part : parts) sum += part.energy;
    if (!runner_->objects) return sum;
    const std::vector<ObjectState>& objects = runner_->objects->states();
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i].present) sum += objects[i].kineticEnergy(world_.objects()[i]);
    return sum;
}

void CpuSolver::scaleVelocities(double factor) {
    if (runner_->rest) runner_->rest->wakeAll();
    for (const auto& run : bodies_) run->scaleVelocities(static_cast<float>(factor));
    if (runner_->objects) runner_->objects->scaleVelocities(factor);
}

int CpuSolver::threads() const {
    return runner_->team.size();
}
bool CpuSolver::asleep(int body) const {
    return bodies_[body]->active() && bodies_[body]->asleep();
}

bool CpuSolver::objectAsleep(int object) const {
    return runner_->objects && runner_->objects->asleep(object);
}

double CpuSolver::bytesPerTetrahedron() const {
    std::size_t bytes = 0;
    for (const auto& run : bodies_) bytes += run->bytes();
    if (runner_->contact) bytes += runner_->contact->bytes();
    return static_cast<double>(bytes) / (kTetrahedraPerCell * world_.presentCells());
}

}  // namespace sunder::cpu
