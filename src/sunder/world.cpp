#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/diagnostics.hpp"
#include "core/fnv.hpp"
#include "core/limit_notes.hpp"
#include "core/limits.hpp"
#include "core/loss_notes.hpp"
#include "core/pieces.hpp"
#include "core/wording.hpp"
#include "sunder/convert.hpp"
#include "sunder/guard.hpp"
#include "sunder/world_impl.hpp"

namespace sunder {

namespace {

constexpr double kMostSeconds = 100;     ///< of one step()
constexpr int kMostIncidents = 1000000;  ///< kept until they are taken

/// Throws InputError.
void checkNumber(double value, double least, double most, const std::string& what) {
    if (value >= least && value <= most) return;  // not NaN
    throw core::InputError(what + " must be from " + core::formatNumber(least) + " to " +
                           core::formatNumber(most) + ", not " + core::formatNumber(value));
}

void checkPlace(const Vec3& v, const std::string& what) {
    for (const double value : {v.x, v.y, v.z})
        checkNumber(value, -core::kMaxLength, core::kMaxLength, what);
}

/// What options may be, before anything is made.
cpu::Threads threadsOf(const WorldOptions& options) {
    checkNumber(options.incidents, 0, kMostIncidents, "incidents");
    checkNumber(options.threads, 0, cpu::kMaxThreads, "threads");
    if (!options.tasks) return options.threads;
    if (!options.tasks->concurrency || !options.tasks->forEach)
        throw core::InputError("a task system needs both of its functions");
    return cpu::Threads(options.tasks);
}

const sim::SolverInfo& findCpuSolver(std::string_view name) {
    if (name.empty()) return sim::cpuSolvers().front();
    std::vector<std::string> names;
    for (const sim::SolverInfo& solver : sim::cpuSolvers()) {
        if (solver.name == name) return solver;
        names.push_back(solver.name);
    }
    throw core::InputError("there is no solver '" + std::string(name) +
                           "' without a device; known: " + core::joined(names));
}

constexpr std::size_t kWord = 8;  ///< bytes of a number that saveState() adds

void append(std::vector<std::byte>& bytes, std::uint64_t word) {
    for (std::size_t i = 0; i < kWord; ++i)
        bytes.push_back(static_cast<std::byte>(word >> 8 * i & 0xff));
}

std::uint64_t wordAt(std::span<const std::byte> bytes, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < kWord; ++i)
        word |= static_cast<std::uint64_t>(bytes[at + i]) << 8 * i;
    return word;
}

/// Of the last two numbers.
std::uint64_t checksumOfLast(std::span<const std::byte> bytes) {
    core::Fnv1a hash;
    hash.add(bytes.last(2 * kWord));
    return hash.value();
}

}  // namespace

Device::~Device() = default;

World::Impl::Impl(const WorldDesc& description, const WorldOptions& options, sim::Backend* device)
    : backend(device) {
    if (description.missing) throw core::InputError(description.missing->message);
    const cpu::Threads threads = threadsOf(options);
    const sim::SolverInfo& info =
        backend ? backend->findSolver(options.solver) : findCpuSolver(options.solver);
    core::WorldDescription inner = toCore(description);
    const auto stay = enter();
    layout = layOut(std::move(inner));
    simulation.emplace(layout, info, threads, static_cast<std::size_t>(options.incidents));
    solver = info.name;
    startNotes = core::limitNotes(world());
    if (options.settle) {
        const cpu::Start& start = simulation->start(options.progress);
        if (std::string note = cpu::restlessWarning(start); !note.empty())
            startNotes.push_back(std::move(note));
        simulation->restart();
    }
    if (backend) backend->check();
}

std::shared_ptr<const sim::Layout> World::Impl::layOut(core::WorldDescription inner) const {
    return backend ? backend->layOut(std::move(inner))
                   : std::make_shared<const sim::Layout>(std::move(inner));
}

void World::Impl::extend(const WorldDesc& description) {
    const auto start = std::chrono::steady_clock::now();
    if (description.missing) throw core::InputError(description.missing->message);
    core::WorldDescription larger = world().description();
    const core::WorldDescription given = toCore(description);
    const auto append = [](const auto& from, auto& to, const char* what) {
        if (from.size() < to.size())
            throw core::InputError("extend: the description has " + std::to_string(from.size()) +
                                   " " + what + ", the world " + std::to_string(to.size()) +
                                   "; it takes the world's own with more at the ends");
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(to.size()), from.end());
    };
    append(given.materials, larger.materials, "materials");
    append(given.bodies, larger.bodies, "bodies");
    append(given.objects, larger.objects, "objects");
    larger.contact = larger.contact || !larger.objects.empty();
    std::shared_ptr<const sim::Layout> next = layOut(std::move(larger));
    simulation->extend(next);
    layout = std::move(next);
    picker.reset();
    mesh.reset();
    startNotes = core::limitNotes(world());
    ++growths;
    growthSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

World::Impl::~Impl() {
    const auto stay = backend ? backend->enter(sim::Backend::Work::Deletes) : nullptr;
    simulation.reset();
    layout.reset();
}

void World::Impl::checkObject(int object, const char* what) const {
    const auto count = static_cast<int>(world().objects().size());
    if (object >= 0 && object < count) return;
    throw core::InputError(std::string(what) + ": there is no object " + std::to_string(object) +
                           "; the world has " + std::to_string(count));
}

void World::Impl::checkBody(int body, const char* what) const {
    const auto count = static_cast<int>(world().bodies().size());
    if (body >= 0 && body < count) return;
    throw core::InputError(std::string(what) + ": there is no body " + std::to_string(body) +
                           "; the world has " + std::to_string(count));
}

Result<void> World::Impl::setPresent(int body, bool present, const char* what) {
    checkBody(body, what);
    if (simulation->present(body) == present)
        throw core::InputError(std::string(what) + ": body " + std::to_string(body) +
                               (present ? " is there already" : " is not there"));
    simulation->setPresent(body, present);
    return {};
}

template <class Work>
auto World::Impl::within(const Work& work) -> decltype(work()) {
    if (failure) return *failure;
    auto result = guarded([&]() -> decltype(work()) {
        const auto stay = enter();
        return work();
    });
    if (!result &&
        (result.error().code == Error::Code::Device || result.error().code == Error::Code::Bug))
        failure = result.error();
    return result;
}

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&& other) noexcept = default;
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldDesc& description, const WorldOptions& options) {
    return guarded([&]() -> Result<World> {
        sim::Backend* backend = nullptr;
        if (options.device) {
            const Result<sim::Backend*> made = options.device->backend();
            if (!made) return made.error();
            backend = *made;
        }
        return World(std::make_unique<Impl>(description, options, backend));
    });
}

// --- Time ---

Result<void> World::step(double seconds) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        checkNumber(seconds, 0, kMostSeconds, "a step's seconds");
        const double length = w.world().step(), due = w.rest + seconds;
        // What is missing of a substep by rounding alone is not waited for.
        // Nor does time go back where a rounding left less than nothing.
        const auto steps = static_cast<int>(std::max(std::floor(due / length + 1e-6), 0.));
        w.simulation->advance(steps);
        w.rest = due - steps * length;
        if (w.backend) w.backend->check();
        return {};
    });
}

double World::time() const {
    return impl_->simulation->time();
}

std::int64_t World::substeps() const {
    return impl_->simulation->step();
}

Result<void> World::finish() {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.simulation->finish();
        if (w.backend) w.backend->check();
        return {};
    });
}

// --- Input ---

Result<void> World::push(const Push& push) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.simulation->push(toCore(push, w.world().description().bodies));
        return {};
    });
}

Result<void> World::throwObject(const Throw& thrown) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.checkObject(thrown.object, "throwObject");
        w.simulation->throwObject(
            {0, thrown.object, toCore(thrown.from), toCore(thrown.velocity), toCore(thrown.spin)});
        return {};
    });
}

Result<void> World::setKinematic(int object, const Transform& transform, Vec3 velocity, Vec3 spin) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.checkObject(object, "setKinematic");
        if (!w.world().description().objects[object].kinematic)
            throw core::InputError("setKinematic: object " + std::to_string(object) +
                                   " is not kinematic");
        checkPlace(transform.position, "setKinematic: position");
        checkPlace(velocity, "setKinematic: velocity");
        checkPlace(spin, "setKinematic: spin");
        core::ObjectState state;
        state.present = true;
        state.position = toCore(transform.position);
        state.orientation = toCore(transform.orientation, "setKinematic: orientation");
        state.velocity = toCore(velocity);
        state.angularMomentum = toCore(spin);  // see core::Object::inverseInertia
        w.simulation->putObject(object, state);
        return {};
    });
}

Result<void> World::removeObject(int object) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.checkObject(object, "removeObject");
        w.simulation->putObject(object, {});
        return {};
    });
}

Result<void> World::addBody(int body) {
    return impl_->within([&] { return impl_->setPresent(body, true, "addBody"); });
}

Result<void> World::removeBody(int body) {
    return impl_->within([&] { return impl_->setPresent(body, false, "removeBody"); });
}

Result<void> World::releaseAnchors(int body) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.checkBody(body, "releaseAnchors");
        if (!w.simulation->present(body))
            throw core::InputError("releaseAnchors: body " + std::to_string(body) +
                                   " is not there");
        if (w.world().description().bodies[body].anchors.empty())
            throw core::InputError("releaseAnchors: body " + std::to_string(body) +
                                   " has no anchors");
        w.simulation->releaseAnchors(body);
        return {};
    });
}

Result<void> World::extend(const WorldDesc& description) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        w.extend(description);
        if (w.backend) w.backend->check();
        return {};
    });
}

// --- Going back ---

Result<std::vector<std::byte>> World::saveState() const {
    Impl& w = *impl_;
    return w.within([&]() -> Result<std::vector<std::byte>> {
        std::vector<std::byte> bytes = w.simulation->saveState();
        append(bytes, std::bit_cast<std::uint64_t>(w.rest));
        append(bytes, checksumOfLast(bytes));
        return bytes;
    });
}

Result<void> World::restoreState(std::span<const std::byte> bytes) {
    Impl& w = *impl_;
    return w.within([&]() -> Result<void> {
        // What follows the simulation's bytes, which end in a checksum of their own: seconds that
        // no substep has taken up, and a checksum of both.
        if (bytes.size() < 3 * kWord)
            throw core::InputError("a saved state of " + std::to_string(bytes.size()) +
                                   " bytes was cut short");
        const std::size_t inside = bytes.size() - 2 * kWord;
        const auto rest = std::bit_cast<double>(wordAt(bytes, inside));
        const bool whole =
            wordAt(bytes, inside + kWord) == checksumOfLast(bytes.first(inside + kWord));
        if (!whole || !(std::abs(rest) <= w.world().step()))
            throw core::InputError(
                "a saved state was cut or changed since; restore what saveState() gave");
        w.simulation->restoreState(bytes.first(inside));
        w.rest = rest;
        return {};
    });
}

// --- Output ---

std::span<const Incident> World::incidents() {
    Impl& w = *impl_;
    w.incidents.clear();
    (void)w.within([&]() -> Result<void> {
        w.finishIncidents(w.simulation->takeIncidents());
        return {};
    });
    return w.incidents;
}

void World::Impl::finishIncidents(const std::vector<core::Incident>& found) {
    const core::World& inner = world();
    const auto materialOf = [&](int cell) {
        return cell < 0 ? -1 : inner.laws()[inner.lawOf(cell)].material;
    };
    for (const core::Incident& i : found)
        incidents.push_back({i.kind == core::Incident::Kind::Break ? Incident::Kind::Break
                                                                   : Incident::Kind::Contact,
                             static_cast<double>(i.step) * inner.step(), fromCore(i.place),
                             i.impulse, inner.bodyOf(i.cell), materialOf(i.cell),
                             i.other < 0 ? -1 : inner.bodyOf(i.other), materialOf(i.other),
                             i.object});
}

std::int64_t World::droppedIncidents() const {
    return impl_->simulation->droppedIncidents();
}

double World::lookTime() const {
    Impl& w = *impl_;
    double time = std::numeric_limits<double>::quiet_NaN();
    (void)w.within([&]() -> Result<void> {
        time = static_cast<double>(w.simulation->lateState().step) * w.world().step();
        return {};
    });
    return time;
}

std::optional<RayHit> World::castRay(Vec3 origin, Vec3 direction) const {
    Impl& w = *impl_;
    const core::Vec3 from = toCore(origin), along = toCore(direction);
    // Whose square may be beyond what numbers hold.
    const double length = along.stableNorm();
    if (!from.allFinite() || !along.allFinite() || !(length > 0)) return std::nullopt;
    std::optional<surface::Spot> spot;
    (void)w.within([&]() -> Result<void> {
        if (!w.picker) {
            w.mesh.emplace(w.world());
            w.picker.emplace(w.world(), *w.mesh);
        }
        spot = w.picker->pick(w.simulation->lateState(), from, along.stableNormalized());
        return {};
    });
    if (!spot) return std::nullopt;
    RayHit hit;
    hit.distance = spot->distance;
    hit.place = fromCore(spot->place);
    hit.normal = fromCore(spot->normal);
    hit.object = spot->object;
    if (spot->cell < 0) return hit;
    hit.body = w.world().bodyOf(spot->cell);
    hit.material = w.world().laws()[w.world().lawOf(spot->cell)].material;
    hit.restPlace = fromCore(spot->rest);
    return hit;
}

Result<std::vector<Piece>> World::pieces() const {
    Impl& w = *impl_;
    return w.within([&]() -> Result<std::vector<Piece>> {
        const core::State& state = w.simulation->lateState();
        std::vector<Piece> pieces;
        for (const core::PieceMotion& p :
             core::pieceMotions(w.world(), state, core::findPieces(w.world(), state)))
            pieces.push_back({p.body, p.cells, p.mass, fromCore(p.centre), fromCore(p.velocity),
                              fromCore(p.low), fromCore(p.high), p.anchored});
        return pieces;
    });
}

Result<ObjectState> World::object(int object) const {
    Impl& w = *impl_;
    return w.within([&]() -> Result<ObjectState> {
        w.checkObject(object, "object");
        return fromCore(w.simulation->lateState().objects[object], w.world().objects()[object]);
    });
}

Result<int> World::brokenBonds() const {
    Impl& w = *impl_;
    return w.within(
        [&]() -> Result<int> { return core::brokenBonds(w.world(), w.simulation->lateState()); });
}

Result<std::uint64_t> World::stateHash() const {
    Impl& w = *impl_;
    return w.within(
        [&]() -> Result<std::uint64_t> { return core::stateHash(w.simulation->state()); });
}

WorldSize World::size() const {
    const core::World& inner = impl_->world();
    return {inner.presentCells(), core::kCorners * inner.presentCells(), inner.bondCount()};
}

std::string_view World::solver() const {
    return impl_->solver;
}

std::vector<std::string> World::notes() const {
    Impl& w = *impl_;
    std::vector<std::string> notes = w.startNotes;
    if (w.growths > 0)
        notes.push_back("the world was extended " +
                        (w.growths == 1 ? "once" : std::to_string(w.growths) + " times") +
                        "; the last time took " +
                        core::formatNumber(std::round(1e4 * w.growthSeconds) / 10) + " ms");
    (void)w.within([&]() -> Result<void> {
        for (std::string& note : core::lossNotes(w.world(), w.simulation->solver()))
            notes.push_back(std::move(note));
        return {};
    });
    return notes;
}

}  // namespace sunder
