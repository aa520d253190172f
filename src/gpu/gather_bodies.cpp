// Which bodies of GatherSolver move: who comes and goes, sleeps and wakes.
#include <algorithm>
#include <limits>

#include "core/sleep.hpp"
#include "gpu/body_ranges.hpp"
#include "gpu/gather.hpp"

namespace sunder::gpu {

using namespace core;

void GatherSolver::push(const Event& event) {
    events_.schedule().add(event, step_);
    nextWake_ = std::min(nextWake_, event.nextStep(step_));
}

void GatherSolver::putObject(int object, const ObjectState& state) {
    wake(memberOfObject(world_, object));
    objects_->put(object, state, step_);
    wakeThreatened();
    bodiesChanged();
}

void GatherSolver::setPresent(int body, bool present) {
    if (book_.present(body) == present) return;
    if (book_.active(body)) {
        std::vector<RestBox> own;
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (chunk.box.member == memberOfBody(body)) own.push_back(chunk.box);
        wakeAround(body, own);
    }
    book_.setPresent(body, present);
    bookChanged();
    const TexelRange cells = cellsOf(world_, body);
    writeBoth(cells, world_.initialState());
    if (!holds(body)) return;
    changed(body);
    if (present) {
        const Box box = world_.bodies()[body].bounds();
        const Vec3 reach = Vec3::Constant(restReach(world_.bodies()[body]));
        wakeAround(body, {{memberOfBody(body), box.low - reach, box.high + reach}});
    }
    bodiesChanged();
    relink(body);
}

void GatherSolver::releaseAnchors(int body) {
    if (!book_.releaseAnchors(body)) return;
    bookChanged();
    if (!holds(body)) return;
    // Contacts are searched for anew only where something wakes, for others' bits.
    if (asleep(body)) {
        wake(memberOfBody(body));
        bodiesChanged();
    }
    changed(body);
    relink(body);
}

void GatherSolver::relink(int body) {
    const TexelRange cells = cellsOf(world_, body);
    CellSet own(stage_, 1, "a body's cells");
    own.set({&cells, 1}, columns_);
    bindInputs();
    writeLinks(own);
}

void GatherSolver::wakeAround(int body, const std::vector<RestBox>& own) {
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (asleep(chunk.box.member)) boxes.push_back(chunk.box);
    };
    woke(book_.wakeAround(body, own, addBoxes, knownObjects()));
}

const std::vector<ObjectState>& GatherSolver::knownObjects() const {
    static const std::vector<ObjectState> kNone;
    return objects_ ? objects_->known() : kNone;
}

void GatherSolver::bookChanged() {
    for (int body = 0; body < bodyCount(); ++body)
        monitor_.setBody(body, present(body), book_.released(body));
    released_.write(book_);
}

/// Looks for bodies and objects that have come to rest, and for sleepers that something hits.
void GatherSolver::watch() {
    RestMonitor::News news;
    {
        const TimedPass timed(passTimer_, "rest");
        if (contact_) {
            gl::bindTexture(kSummaries, GL_TEXTURE_2D_ARRAY, contact_->summaries());
            gl::bindTexture(kHastes, GL_TEXTURE_2D_ARRAY, contact_->hastes());
        }
        news = monitor_.look(step_);
        if (contact_) contact_->forgetHaste();
    }
    newNodeWatch_ = newBondWatch_ = true;
    droppedContacts_ = std::max(droppedContacts_, news.dropped);
    raiseHaste(contactHaste_, news.haste);
    if (objects_) objects_->look(step_, monitor_.interval());
    rest();
    for (const int body : news.hit) wake(memberOfBody(body));
    if (objects_) wakeThreatened();
    if (!news.hit.empty()) bodiesChanged();
}

void GatherSolver::rest() {
    const std::int64_t before = step_ - monitor_.interval();
    if (events_.schedule().nextBlast(before) <= step_)
        for (int object = 0; object < objectCount(); ++object)
            if (blastedWithin(object, before, step_ + 1)) objects_->disturb(object, step_);
    const std::vector<bool> pushed = blasted();
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (book_.active(chunk.box.member)) boxes.push_back(chunk.box);
    };
    const auto [bodies, objects] =
        book_.settle([&](int body) { return monitor_.ready(body) && !pushed[body]; }, addBoxes,
                     [this](int object) { return objects_->restStatus(object); }, knownObjects());
    if (!objects.empty()) objects_->setAsleep(objects, true, step_);
    if (!bodies.empty()) fallAsleep(bodies);
}

void GatherSolver::woke(const BodyBook::Members& members) {
    if (!members.objects.empty()) objects_->setAsleep(members.objects, false, step_);
    for (const int body : members.bodies) changed(body);
}

void GatherSolver::changed(int body) {
    monitor_.disturb(body, step_);
}

/// Their velocities become zero, and both halves of the ping-pong the same: the passes no longer
/// touch them.
void GatherSolver::fallAsleep(const std::vector<int>& calm) {
    TexelRanges falling(calm.size(), "calm cells");
    falling.set(rangesOf(world_, calm), columns_);
    const auto copy = [&](const gl::Program& program, const TexelTarget& from,
                          const TexelTarget& to, int part) {
        gl::bindTexture(kRecords, GL_TEXTURE_2D_ARRAY, from.texture());
        to.fill(program, falling, part);
    };
    const TexelTarget &nodes = nodes_[currentNodes_], &otherNodes = nodes_[1 - currentNodes_];
    for (int part = 0; part < kNodeParts; ++part) {
        copy(stillNodePrograms_[part], nodes, otherNodes, part);
        copy(stillNodePrograms_[part], otherNodes, nodes, part);
    }
    copy(stillBondProgram_, bonds_[currentBonds_], bonds_[1 - currentBonds_], 0);
    if (links_.size() > 1) {
        CellSet cells(stage_, calm.size(), "calm cells");
        cells.set(rangesOf(world_, calm), columns_);
        writeLinks(cells);
    }
    bodiesChanged();
}

void GatherSolver::wakePushed() {
    const EventSchedule& events = events_.schedule();
    const std::vector<bool> pushed = blasted();
    bool any = false, acts = false, begins = false;
    for (const int index : events.blasts()) {
        const Event& blast = events.all()[index];
        if (blast.nextStep(step_) > step_) continue;
        acts = true;
        begins |= blast.nextStep(step_ - 1) == step_;
    }
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body) || !(pushed[body] || events.pushedWithin(body, step_, step_ + 1)))
            continue;
        wake(memberOfBody(body));
        any = true;
    }
    for (int object = 0; acts && object < objectCount(); ++object) {
        if (!objectAsleep(object) || !blastedWithin(object, step_, step_ + 1)) continue;
        wake(memberOfObject(world_, object));
        any = true;
    }
    if (any) bodiesChanged();
    if (objects_ && begins) wakeThreatened();
    findNextWake(step_ + 1);
}

std::vector<bool> GatherSolver::blasted() const {
    const EventSchedule& events = events_.schedule();
    std::vector<bool> reached(world_.bodies().size());
    for (const int index : events.blasts()) {
        const Event& blast = events.all()[index];
        if (blast.nextStep(step_) > step_) continue;
        // Without contact nobody knows where they are.
        if (!contact_) reached.assign(reached.size(), true);
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (const auto body = static_cast<std::size_t>(chunk.box.member);
                body < reached.size() && blast.reaches(chunk.box.low, chunk.box.high))
                reached[body] = true;
    }
    return reached;
}

bool GatherSolver::blastedWithin(int object, std::int64_t from, std::int64_t to) const {
    if (objects_->restStatus(object) == RestIslands::Status::Apart) return false;
    const RestBox box = restBoxOf(world_, object, knownObjects()[object]);
    return events_.schedule().blastWithin(from, to, box.low, box.high);
}

void GatherSolver::findNextWake(std::int64_t from) {
    nextWake_ = std::numeric_limits<std::int64_t>::max();
    const EventSchedule& events = events_.schedule();
    bool anyAsleep = false;
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body)) continue;
        anyAsleep = true;
        nextWake_ = std::min(nextWake_, events.nextPush(body, from));
    }
    for (int object = 0; object < objectCount(); ++object) anyAsleep |= objectAsleep(object);
    if (anyAsleep) nextWake_ = std::min(nextWake_, events.nextBlast(from));
}

/// What sleeps where something that moves may come before the next look.
void GatherSolver::wakeThreatened() {
    objects_->expect(events_.schedule(), step_);
    bool any = false;
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body) || !objects_->threatens(body)) continue;
        wake(memberOfBody(body));
        any = true;
    }
    for (int object = 0; object < objectCount(); ++object) {
        if (!objects_->asleep(object)) continue;
        bool threatened = objects_->threatensObject(object);
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            threatened |= book_.awake(chunk.box.member) &&
                          objects_->threatenedBy(object, chunk.box, chunk.fastest);
        if (!threatened) continue;
        wake(memberOfObject(world_, object));
        any = true;
    }
    if (any) bodiesChanged();
}

void GatherSolver::bodiesChanged() {
    const std::vector<TexelRange> awake = rangesOf(world_, book_.awakeBodies()),
                                  active = rangesOf(world_, book_.activeBodies());
    awake_.set(awake, columns_);
    if (blocks_) blocks_->setBodies(book_.awakeBodies());
    if (contact_) contact_->setCells(awake, active);
    if (objects_) objects_->setCells(active);
    findNextWake(step_);
}

}  // namespace sunder::gpu
