#include "core/incident_watch.hpp"

#include <algorithm>

#include "core/archive.hpp"

namespace sunder::core {

IncidentWatch::IncidentWatch(const World& world, IncidentRing& ring)
    : world_(world), ring_(ring), interval_(stepsPerLook(world)) {
    if (world.description().contact) loads_.resize(static_cast<std::size_t>(world.cellCount()));
}

void IncidentWatch::push(int cell, double impulse, double hardest, int other, int object) {
    Load& load = loads_[cell];
    load.now += impulse;
    if (hardest <= load.hardest) return;
    load.hardest = hardest;
    load.other = other;
    load.object = object;
}

void IncidentWatch::forget() {
    broken_.clear();
    std::fill(loads_.begin(), loads_.end(), Load{});
}

void IncidentWatch::archive(Archive& a, const World& world, IncidentWatch* watch) {
    a.section("incidents");
    const bool watched = a.flag(watch != nullptr);
    if (!watched) {
        if (a.reads() && watch) watch->forget();
        return;
    }
    // Most cells were not pushed.
    struct Pushed {
        int cell;
        Load load;
    };
    std::vector<Pushed> pushed;
    std::vector<int> broken;
    if (a.writes()) {
        broken = watch->broken_;
        for (int cell = 0; cell < static_cast<int>(watch->loads_.size()); ++cell) {
            const Load& load = watch->loads_[cell];
            if (load.now != 0 || load.before != 0 || load.earlier != 0)
                pushed.push_back({cell, load});
        }
    }
    a.list(broken, static_cast<std::size_t>(world.bondSlots()),
           [&](int& bond) { bond = archiveBond(a, world, bond); });
    const auto cell = [&](int now, int low) {
        const int got = a.whole(now, low, world.cellCount() - 1);
        a.require(a.writes() || got < 0 || world.present(got));
        return got;
    };
    a.list(pushed, static_cast<std::size_t>(world.cellCount()), [&](Pushed& p) {
        p.cell = cell(p.cell, 0);
        for (double* impulse : {&p.load.now, &p.load.before, &p.load.earlier, &p.load.hardest})
            *impulse = a.real(*impulse, 0.);
        p.load.other = cell(p.load.other, -1);
        p.load.object = a.whole(p.load.object, -1, static_cast<int>(world.objects().size()) - 1);
    });
    if (!a.reads() || !watch) return;
    watch->forget();
    watch->broken_ = std::move(broken);
    for (const Pushed& p : pushed)
        if (!watch->loads_.empty()) watch->loads_[p.cell] = p.load;
}

void IncidentWatch::look(std::int64_t step, const std::function<Vec3(int node)>& place) {
    // Mean place of the corners that have all of these bits.
    const auto centre = [&](int cell, int bits) {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (int corner = 0; corner < kCorners; ++corner) {
            if ((corner & bits) != bits) continue;
            sum += place(kCorners * cell + corner);
            ++count;
        }
        return Vec3(sum / count);
    };
    std::vector<Incident> found;
    std::sort(broken_.begin(), broken_.end());
    for (const int bond : broken_) {
        found.push_back(breakOf(world_, bond, step));
        found.back().place = centre(bond / kBondsPerCell, 1 << bond % kBondsPerCell);
    }
    broken_.clear();
    for (int cell = 0; cell < static_cast<int>(loads_.size()); ++cell) {
        Load& load = loads_[cell];
        const double impulse = blow(load.now, load.before, load.earlier);
        if (impulse > 0 && impulse >= kBlowSpeed * world_.cellMass(cell))
            found.push_back({Incident::Kind::Contact, step, centre(cell, 0), impulse, cell,
                             load.other, load.object});
        load = {0, load.now, load.before, 0, -1, -1};
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Incident& a, const Incident& b) { return a.cell < b.cell; });
    for (const Incident& incident : found) ring_.push(incident);
}

}  // namespace sunder::core
