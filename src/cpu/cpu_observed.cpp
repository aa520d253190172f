// Steps of `cpu` under a PassObserver: pass after pass over all bodies by one thread, where
// otherwise a body goes through all of them while it lies in the cache. The bits are the same.
#include "cpu/cpu_runner.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

void tellForces(PassObserver& observer, const char* pass, const cpu::BodyArrays& body) {
    for (int component = 0; component < cpu::kNodeComponents; ++component)
        observer.wrote(
            pass, {body.force + component * body.stride, static_cast<std::size_t>(body.cells)});
}

/// What links decide: the masses of the joined groups.
void tellLinks(PassObserver& observer, const cpu::BodyArrays& body) {
    observer.wrote("links", {body.inverseMass,
                             static_cast<std::size_t>(body.vectors * kCorners * cpu::kLanes)});
}

}  // namespace

bool CpuSolver::setPassObserver(PassObserver* observer) {
    runner_->observer = observer;
    return true;
}

void CpuSolver::advanceObserved(int steps, bool contact) {
    Runner& runner = *runner_;
    PassObserver& observer = *runner.observer;
    const cpu::FlushDenormals flush;
    const auto forAwake = [&](const auto& work) {
        for (int body = 0; body < bodyCount(); ++body)
            if (book_.active(body) && !bodies_[body]->asleep()) work(*bodies_[body], body);
    };
    const auto tell = [&](const char* pass) {
        forAwake([&](BodyRun& run, int) { tellForces(observer, pass, run.arrays()); });
    };
    const auto touches = [&](int body) { return contact && runner.touching[body]; };
    for (std::int64_t step = step_; step < step_ + steps; ++step) {
        for (const int body : book_.activeBodies()) bodies_[body]->startStep(step);
        forAwake([](BodyRun& run, int) { run.elements(0, run.arrays().vectors); });
        tell("elements");
        if (contact && runner.contact->wantsFreeMotions())
            forAwake([&](BodyRun&, int body) {
                if (touches(body)) runner.contact->findFreeMotions(runner.contact->cellsOf(body));
            });
        if (contact) {
            forAwake([&](BodyRun&, int body) {
                if (touches(body)) runner.contact->push(runner.contact->cellsOf(body));
            });
            tell("contacts");
        }
        if (contact && runner.objects) {
            runner.objects->push(*runner.objectCells);
            tell("objects");
        }
        forAwake([&](BodyRun& run, int body) {
            run.nodes(0, run.arrays().vectors, 0);
            run.endStep();
            if (touches(body)) runner.contact->follow(runner.contact->tilesOf(body));
        });
        forAwake([&](BodyRun& run, int) { tellLinks(observer, run.arrays()); });
        if (contact && runner.objects) runner.objects->move();
    }
}

}  // namespace sunder::cpu
