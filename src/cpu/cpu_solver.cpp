#include "cpu/cpu_solver.hpp"

#include <algorithm>

#include "core/archive.hpp"
#include "core/incident.hpp"
#include "cpu/cpu_runner.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// A stretch of fewer vectors is not worth a thread of its own: threads take half a microsecond to
/// meet, and one vector takes as long.
constexpr int kVectorsPerPart = 4;

}  // namespace

CpuSolver::CpuSolver(const World& world, const Threads& threads)
    : world_(world), events_(world), book_(world), runner_(std::make_unique<Runner>(threads)) {
    Runner& runner = *runner_;
    runner.laws = cpu::makeLaws(world);
    for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body)
        bodies_.push_back(std::make_unique<BodyRun>(world, body, runner.laws, events_));
    runner.touching.assign(bodies_.size(), false);
    if (world.description().contact) {
        std::vector<const cpu::BodyArrays*> arrays;
        for (const auto& run : bodies_) arrays.push_back(&run->arrays());
        runner.contact.emplace(world, arrays);
        runner.restInterval =
            world.contactInterval() * std::max(1, stepsPerLook(world) / world.contactInterval());
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
    const std::vector<int> active = book_.activeBodies();
    int cells = 0;
    for (const int body : active) cells += bodies_[body]->cells();
    // A body is split when one thread alone would still be at it after the others were done.
    const int fairShare = cells / (2 * runner.team.size());
    runner.largeCells = std::max(fairShare, 2 * kVectorsPerPart * cpu::kLanes);
    for (const int body : active) {
        const bool large = bodies_[body]->cells() > runner.largeCells;
        (runner.team.size() > 1 && large ? runner.split : runner.whole).push_back(body);
    }
    if (runner.contact) runner.contact->forget();
}

CpuSolver::~CpuSolver() = default;

void CpuSolver::advance(int steps) {
    Runner& runner = *runner_;
    runner.team.run([&] {
        if (!runner.contact || !book_.holdsAny()) {
            advanceTo(step_ + steps, false);
            return;
        }
        const int interval = world_.contactInterval();
        for (const std::int64_t end = step_ + steps; step_ < end;) {
            std::int64_t next = std::min(end, (step_ / interval + 1) * interval);
            for (const Throw& thrown : world_.throws())
                if (thrown.step > step_) next = std::min(next, thrown.step);
            // What accelerates objects may make a search due at each step.
            std::vector<Blast> blasts;
            if (runner.objects) {
                blasts = events_.blastsAt(step_);
                next = std::min(next, blasts.empty() ? events_.nextBlast(step_) : step_ + 1);
            }
            startThrows();
            const bool woke = wakePushed(next);
            if (!blasts.empty()) runner.objects->accelerate(blasts);
            if (step_ % runner.restInterval == 0) rest();
            if (woke || runner.contact->due() || step_ % interval == 0 ||
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
    Runner& runner = *runner_;
    const auto alone = [&](int body) {
        if (runner.touching[body]) return;
        bodies_[body]->advance(step_, steps,
                               [](int vectors, const auto& work) { work(0, vectors, 0); });
    };
    const auto together = [&](int body) {
        if (runner.touching[body]) return;
        bodies_[body]->advance(step_, steps, [&](int vectors, const auto& work) {
            // One each: they take equally long.
            const int parts = std::min({cpu::BodyRun::kMaxParts, runner.team.size(),
                                        std::max(1, vectors / kVectorsPerPart)});
            const auto stretch = [&](int part) {
                work(vectors * part / parts, vectors * (part + 1) / parts, part);
            };
            runner.team.forEach(parts, stretch);
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
    std::vector<bool> active;
    for (int body = 0; body < bodyCount(); ++body) active.push_back(book_.active(body));
    for (bool again = true; again;) {
        again = false;
        bool awake = false;
        for (int body = 0; body < bodyCount(); ++body) {
            const BodyRun& run = *bodies_[body];
            const bool moves = active[body] && !run.asleep();
            status[body] = {active[body], moves, run.relinks()};
            awake |= moves;
        }
        if (awake)
            contact.search(status, [&](int count, const std::function<void(int)>& work) {
                runner.team.forEach(count, work);
            });
        else
            contact.rest();
        if (runner.objects) runner.objects->search(*runner.objectCells, active);
        for (int body = 0; body < bodyCount(); ++body) {
            const bool near = runner.objects && runner.objects->near(body);
            const bool hit = bodies_[body]->asleep() && runner.objects && runner.objects->hit(body);
            runner.touching[body] = contact.touching(body) || near;
            bodies_[body]->setTouching(runner.touching[body]);
            if (!(contact.hit(body) && bodies_[body]->asleep()) && !hit) continue;
            wake(memberOfBody(body));
            again = true;
        }
        for (int object = 0; object < objectCount(); ++object) {
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
    for (int body = 0; body < bodyCount(); ++body) {
        if (!bodies_[body]->asleep() || !bodies_[body]->pushedWithin(step_, until)) continue;
        wake(memberOfBody(body));
        woke = true;
    }
    return wakePushedObjects(until) || woke;
}

bool CpuSolver::wakePushedObjects(std::int64_t until) {
    if (events_.nextBlast(step_) >= until) return false;
    bool woke = false;
    for (int object = 0; object < static_cast<int>(objectStates().size()); ++object) {
        if (runner_->objects->restStatus(object) == RestIslands::Status::Apart) continue;
        const RestBox box = restBoxOf(world_, object, objectStates()[object]);
        if (!events_.blastWithin(step_, until, box.low, box.high)) continue;
        woke |= objectAsleep(object);
        wake(memberOfObject(world_, object));
        runner_->objects->wake(object);
    }
    return woke;
}

void CpuSolver::woke(const BodyBook::Members& members) {
    for (const int body : members.bodies) bodies_[body]->wake();
    for (const int object : members.objects) runner_->objects->wake(object);
}

const std::vector<ObjectState>& CpuSolver::objectStates() const {
    static const std::vector<ObjectState> kNone;
    return runner_->objects ? runner_->objects->states() : kNone;
}

void CpuSolver::rest() {
    Runner& runner = *runner_;
    if (runner.objects) runner.objects->look(runner.restInterval);
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const int body : book_.activeBodies()) bodies_[body]->addRestBoxes(boxes);
    };
    const auto [bodies, objects] = book_.settle(
        [this](int body) { return bodies_[body]->ready(); }, addBoxes,
        [&](int object) { return runner.objects->restStatus(object); }, objectStates());
    for (const int body : bodies) bodies_[body]->fallAsleep();
    for (const int object : objects) runner.objects->fallAsleep(object);
}

void CpuSolver::findIslands() {
    Runner& runner = *runner_;
    runner.islands = runner.contact->islands();
    if (!runner.objects) return;
    const auto near = [&](int body) { return runner.objects->near(body); };
    std::vector<int> together;
    for (int body = 0; body < bodyCount(); ++body)
        if (near(body) && !runner.contact->touching(body)) together.push_back(body);
    std::erase_if(runner.islands, [&](const std::vector<int>& island) {
        if (std::none_of(island.begin(), island.end(), near)) return false;
        together.insert(together.end(), island.begin(), island.end());
        return true;
    });
    std::sort(together.begin(), together.end());
    runner.islands.insert(runner.islands.begin(), std::move(together));
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
    if (book_.present(body) == present) return;
    const bool touches = runner_->contact && book_.holds(body);
    if (touches && !present) wakeAround(body);
    book_.setPresent(body, present);
    bodies_[body]->setReleased(false);
    bodies_[body]->load(world_.initialState());
    if (touches && present) wakeAround(body);
    shareOut();
}

void CpuSolver::releaseAnchors(int body) {
    if (!book_.releaseAnchors(body)) return;
    bodies_[body]->setReleased(true);
    if (!holds(body)) return;
    bodies_[body]->relink();
    wake(memberOfBody(body));
    // However calm it was up to now.
    bodies_[body]->wake();
}

void CpuSolver::wakeAround(int body) {
    std::vector<RestBox> own;
    bodies_[body]->addRestBoxes(own);
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (int other = 0; other < bodyCount(); ++other)
            if (book_.asleep(other)) bodies_[other]->addRestBoxes(boxes);
    };
    woke(book_.wakeAround(body, own, addBoxes, objectStates()));
}

void CpuSolver::setIncidents(IncidentRing* ring) {
    Runner& runner = *runner_;
    runner.watch = ring ? std::make_unique<IncidentWatch>(world_, *ring) : nullptr;
    for (const auto& run : bodies_) run->listBreaks(ring != nullptr);
    if (runner.contact) runner.contact->setWatch(runner.watch.get());
    if (runner.objects) runner.objects->setWatch(runner.watch.get());
}

double CpuSolver::kineticEnergy() const {
    struct Part {
        int body, first, end;
        double energy = 0;
    };
    constexpr int kVectors = 256;  // whatever the number of threads: sums are rounded
    std::vector<Part> parts;
    for (const int body : book_.activeBodies()) {
        const int vectors = bodies_[body]->arrays().vectors;
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
    book_.wakeAll();
    for (const auto& run : bodies_) run->scaleVelocities(static_cast<float>(factor));
    if (runner_->objects) runner_->objects->scaleVelocities(factor);
}

int CpuSolver::threads() const {
    return runner_->team.size();
}

bool CpuSolver::asleep(int body) const {
    return book_.active(body) && bodies_[body]->asleep();
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
