// Calls of the public library in any order, with sensible and senseless numbers: whatever is
// refused changes nothing and says why in a sentence, and whatever is accepted can be gone on from.
//
// The input is a world of few cells, then calls. Two worlds get them: one through sunder.hpp, one
// through sunder.h. They have to stay the same to the bit, though only the first is saved and
// looked at in between.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/fuzzer.hpp"
#include "sunder/c_handles.hpp"

using namespace sunder;

namespace {

// So that an input takes milliseconds.
constexpr int kFewCells = 40, kFewSubsteps = 240, kFewCalls = 48;
constexpr std::size_t kFewSaves = 4;

using State = std::vector<std::byte>;

void promise(bool kept, const char* what) {
    if (kept) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

void checkError(const Error& error) {
    promise(error.code == Error::Code::Input, "only the input is wrong");
    fuzz::checkSentence(core::InputError(error.message));
}

/// Takes values from the input.
class Input : public fuzz::Input {
  public:
    using fuzz::Input::Input;

    bool oneIn(std::size_t count) { return below(count) == count - 1; }

    /// Mostly a sensible number of this range; else any.
    double number(double low, double high) {
        const double share = take<std::uint8_t>() / 255.0;
        if (calm || !oneIn(24)) return low + share * (high - low);
        wild = true;
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        constexpr double kSenseless[] = {std::numeric_limits<double>::quiet_NaN(),
                                         kInfinity,
                                         -kInfinity,
                                         0.,
                                         -0.,
                                         -1.,
                                         1e-310,
                                         1e-30,
                                         1e4,
                                         -1e4,
                                         1e12,
                                         -1e12,
                                         1e39,
                                         1e200,
                                         100.,
                                         1e5};
        if (oneIn(2)) return take<double>();
        return kSenseless[below(std::size(kSenseless))];
    }
    Vec3 vector(double low, double high) {
        const double x = number(low, high), y = number(low, high);
        return {x, y, number(low, high)};
    }
    /// Mostly of length 1.
    Quat turn() {
        if (!oneIn(2)) return {};
        Quat q{number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)};
        const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
        if (!calm && (oneIn(8) || !(length > 0))) return q;
        if (!(length > 0)) return {};
        return {q.w / length, q.x / length, q.y / length, q.z / length};
    }
    /// Mostly of something that there is.
    int index(std::size_t count) {
        if (calm && count > 0) return static_cast<int>(below(count));
        if (oneIn(16)) return take<int>();
        return static_cast<int>(below(count + 1)) - (oneIn(8) ? 1 : 0);
    }

    /// Whether all numbers are sensible.
    bool calm = false;
    /// Whether a number that may be senseless has had effect: then those that follow from it need
    /// not stay finite.
    bool wild = false;
};

Material material(Input& input) {
    Material m;
    m.youngModulus = std::pow(10, input.number(4, 9));
    m.density = input.number(100, 3000);
    m.damping = input.number(0, 10);
    m.strength.x = m.strength.y = m.strength.z = std::pow(10, input.number(2, 6));
    m.boundaryStrength = m.strength;
    m.maxStress = m.strength.x;
    m.law = static_cast<ConstitutiveLaw>(input.below(2));
    m.fracture = static_cast<FractureMode>(input.below(!input.calm && input.oneIn(32) ? 5 : 3));
    m.restitution = input.number(0, 1);
    m.spread = input.number(0, 1);
    return m;
}

BodyDesc body(Input& input, std::size_t materials) {
    BodyDesc b;
    b.material = static_cast<int>(input.below(materials));
    if (input.oneIn(32)) b.material = input.index(materials);
    b.size = input.vector(0.1, 0.6);
    b.cells = {static_cast<int>(1 + input.below(4)), static_cast<int>(1 + input.below(3)),
               static_cast<int>(1 + input.below(2))};
    if (input.oneIn(64)) b.cells.x = input.take<int>();
    b.position = input.vector(-1, 1);
    b.position.y = std::abs(b.position.y);
    b.orientation = input.turn();
    b.anchors = static_cast<Side>(input.oneIn(4) ? input.below(input.calm ? 64 : 80) : 0);
    if (input.oneIn(4))
        b.regions.push_back({{},
                             {input.calm ? 0 : static_cast<int>(input.below(3)), 0, 0},
                             input.index(materials)});
    b.mayOverlap = !input.oneIn(16);
    return b;
}

Object object(Input& input) {
    Object o;
    o.shape = static_cast<Object::Shape>(input.below(!input.calm && input.oneIn(32) ? 5 : 3));
    o.size = input.vector(0.05, 0.5);
    if (o.shape == Object::Shape::Capsule && !input.oneIn(16)) o.size.y += o.size.x;
    o.mass = input.number(0.01, 100);
    if (!input.oneIn(4)) o.position = input.vector(-1, 1);
    o.orientation = input.turn();
    const std::size_t motion = input.below(6);
    if (motion < 3 && o.position) {
        o.velocity = input.vector(-30, 30);
        o.spin = input.vector(-30, 30);
    }
    o.isFixed = motion == 3 && o.position;
    o.isKinematic = motion == 4 || motion == 5;
    o.restitution = input.number(0, 1);
    o.drag = input.number(0, 1);
    if (motion < 3 && o.position && input.oneIn(8))
        o.hungFrom = Vec3{o.position->x, o.position->y + input.number(0.5, 2), o.position->z};
    o.mayOverlap = !input.oneIn(16);
    return o;
}

Push push(Input& input, std::size_t bodies) {
    Push p;
    if (input.oneIn(2)) p.body = input.index(bodies);
    p.at = input.vector(-1, 1);
    p.radius = input.number(0.1, 2);
    const std::size_t kind = input.below(8);
    if (kind < 2) p.velocity = input.vector(-20, 20);
    if (kind == 2 || kind == 5) p.impulse = input.vector(-5, 5);
    if (kind == 3 || kind == 5) p.force = input.vector(-500, 500);
    if (kind == 4 || kind == 1) p.outward = input.number(-20, 20);
    p.falloff = input.oneIn(3) && (p.body == kEveryBody || !input.calm);
    p.duration = input.number(1e-3, 2e-2);
    p.delay = input.oneIn(3) ? input.number(0, 2e-2) : 0;
    return p;
}

Throw thrown(Input& input, std::size_t objects) {
    Throw t;
    t.time = input.number(0, 0.02);
    t.object = input.index(objects);
    t.from = input.vector(-1, 1);
    t.velocity = input.vector(-30, 30);
    t.spin = input.vector(-30, 30);
    return t;
}

WorldDesc described(Input& input) {
    WorldDesc desc;
    for (std::size_t count = 1 + input.below(2); desc.materials.size() < count;)
        desc.addMaterial(material(input));
    for (std::size_t count = input.oneIn(64) ? 0 : 1 + input.below(3); desc.bodies.size() < count;)
        desc.addBody(body(input, desc.materials.size()));
    for (std::size_t count = input.below(4); desc.objects.size() < count;)
        desc.addObject(object(input));
    if (input.oneIn(4)) desc.pushes.push_back(push(input, desc.bodies.size()));
    if (input.oneIn(4)) desc.throws.push_back(thrown(input, desc.objects.size()));
    if (input.oneIn(4)) desc.gravity = input.vector(-20, 20);
    desc.ground = !input.oneIn(4);
    if (input.oneIn(4)) {
        desc.room.emplace();
        desc.room->minX = input.number(-3, -1);
        if (input.oneIn(2)) desc.room->ceiling = input.number(1, 3);
    }
    if (desc.objects.empty()) desc.contact = !input.oneIn(4);
    desc.substep = 1 / input.number(600, 3000);
    desc.fractureInterval = static_cast<int>(1 + input.below(6));
    desc.seed = input.take<std::uint8_t>();
    return desc;
}

bool small(const WorldDesc& desc) {
    double cells = 0;
    for (const BodyDesc& b : desc.bodies) cells += 1. * b.cells.x * b.cells.y * b.cells.z;
    return std::abs(cells) <= kFewCells;
}

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Bytes that another world has saved.
const State& strangersState() {
    static const State state = [] {
        WorldDesc desc;
        desc.addMaterial(Material{});
        desc.addBody({.cells = {3, 1, 1}});
        Result<World> world = World::create(desc, {.threads = 1});
        promise(static_cast<bool>(world), "the simplest world can be made");
        return *world->saveState();
    }();
    return state;
}

/// What saveState() gave, and what held then.
struct Saved {
    State state;
    std::uint64_t hash;
    bool wild;
};

/// A world that is saved and looked at, and its twin in C.
class Twins {
  public:
    Twins(const WorldDesc& desc, World first, World second)
        : desc_(desc), first_(std::move(first)), second_{std::move(second), {}, {}} {}

    void call(Input& input) {
        const bool wasWild = input.wild;
        const auto asInput = [&] { input.wild = wasWild; };
        switch (input.below(16)) {
            case 0:
            case 1:
            case 2:
                step(input);
                break;
            case 3:
            case 4: {
                const Push p = push(input, desc_.bodies.size());
                sunder_push c{p.body, {},        p.radius,  {},         {},
                              {},     p.outward, p.falloff, p.duration, p.delay};
                put(p.at, c.at);
                put(p.velocity, c.velocity);
                put(p.impulse, c.impulse);
                put(p.force, c.force);
                if (!both([&](World& w) { return w.push(p); },
                          [&](sunder_world* w) { return sunder_world_push(w, &c); }))
                    asInput();
                break;
            }
            case 5: {
                const Throw t = thrown(input, desc_.objects.size());
                double from[3], velocity[3], spin[3];
                put(t.from, from);
                put(t.velocity, velocity);
                put(t.spin, spin);
                if (!both([&](World& w) { return w.throwObject(t); },
                          [&](sunder_world* w) {
                              return sunder_world_throw(w, t.object, from, velocity, spin);
                          }))
                    asInput();
                break;
            }
            case 6:
            case 7: {
                const int index = input.index(desc_.objects.size());
                const Transform to{input.vector(-1, 1), input.turn()};
                const Vec3 velocity = input.vector(-30, 30), spin = input.vector(-30, 30);
                double position[3], v[3], s[3];
                put(to.position, position);
                put(velocity, v);
                put(spin, s);
                const Quat& q = to.orientation;
                const double orientation[] = {q.w, q.x, q.y, q.z};
                if (!both([&](World& w) { return w.setKinematic(index, to, velocity, spin); },
                          [&](sunder_world* w) {
                              return sunder_world_set_kinematic(w, index, position, orientation, v,
                                                                s);
                          }))
                    asInput();
                break;
            }
            case 8: {
                const int index = input.index(desc_.objects.size());
                both([&](World& w) { return w.removeObject(index); },
                     [&](sunder_world* w) { return sunder_world_remove_object(w, index); });
                break;
            }
            case 9:
                save(input);
                break;
            case 10:
                restore(input);
                break;
            case 11:
                restoreChanged(input);
                break;
            case 12:
                cast(input);
                break;
            case 13: {
                World moved(std::move(first_));
                first_ = std::move(moved);
                break;
            }
            case 14:
                takeIncidents(input);
                break;
            default:
                comeAndGo(input);
        }
    }

    /// Bodies that come, go and let go, and worlds that grow.
    void comeAndGo(Input& input) {
        const int index = input.index(desc_.bodies.size());
        switch (input.below(6)) {
            case 0:
                both([&](World& w) { return w.addBody(index); },
                     [&](sunder_world* w) { return sunder_world_add_body(w, index); });
                break;
            case 1:
                gone_ |= both([&](World& w) { return w.removeBody(index); },
                              [&](sunder_world* w) { return sunder_world_remove_body(w, index); });
                break;
            case 2:
                both([&](World& w) { return w.releaseAnchors(index); },
                     [&](sunder_world* w) { return sunder_world_release_anchors(w, index); });
                break;
            case 3:
                extend(input);
                break;
            default:
                look(input);
        }
    }

    void extend(Input& input) {
        const bool wasWild = input.wild;
        sunder_desc larger;
        larger.desc = desc_;
        if (input.oneIn(8) && !desc_.objects.empty()) larger.desc.objects.pop_back();
        if (input.oneIn(4)) larger.desc.addMaterial(material(input));
        if (input.oneIn(2)) larger.desc.addObject(object(input));
        larger.desc.addBody(body(input, larger.desc.materials.size()));
        larger.desc.bodies.back().present = input.oneIn(2);
        if (!small(larger.desc)) return;
        if (!both([&](World& w) { return w.extend(larger.desc); },
                  [&](sunder_world* w) { return sunder_world_extend(w, &larger); })) {
            input.wild = wasWild;
            return;
        }
        desc_ = larger.desc;
        gone_ |= !desc_.bodies.back().present;
        saves_.clear();
    }

    void look(const Input& input) {
        const auto pieces = first_.pieces();
        promise(static_cast<bool>(pieces), "pieces are found");
        int cells = 0, number = 0;
        for (const Piece& piece : *pieces) {
            cells += piece.cells;
            promise(input.wild || (finite(piece.centre) && finite(piece.velocity) &&
                                   finite(piece.min) && finite(piece.max)),
                    "pieces are at finite places");
        }
        promise(gone_ ? cells <= first_.size().cells : cells == first_.size().cells,
                "every cell that is there belongs to a piece");
        promise(sunder_world_pieces(&second_, &number) == SUNDER_OK &&
                    number == static_cast<int>(pieces->size()),
                "C finds as many pieces");
        const auto count = static_cast<int>(desc_.objects.size());
        for (int i = -1; i <= count; ++i) {
            const Result<ObjectState> state = first_.object(i);
            promise(static_cast<bool>(state) == (i >= 0 && i < count),
                    "only what is there is found");
            if (!state) {
                checkError(state.error());
                continue;
            }
            promise(input.wild || (finite(state->transform.position) && finite(state->velocity) &&
                                   finite(state->spin)),
                    "objects are at finite places");
        }
        const auto broken = first_.brokenBonds();
        promise(broken && *broken >= 0 && *broken <= first_.size().bonds, "bonds are counted");
        promise(sunder_world_broken_bonds(&second_, &number) == SUNDER_OK && number == *broken,
                "C counts the same bonds");
        for (const std::string& note : first_.notes()) fuzz::checkSentence(core::InputError(note));
        promise(first_.time() == sunder_world_time(&second_), "both are at the same time");
        promise(first_.substeps() >= 0 && first_.droppedIncidents() >= 0, "nothing is negative");
        promise(static_cast<bool>(first_.finish()), "what was asked for can be finished");
        same();
    }

  private:
    static void put(const Vec3& from, double* to) {
        to[0] = from.x;
        to[1] = from.y;
        to[2] = from.z;
    }

    std::uint64_t hash() const {
        const auto hash = first_.stateHash();
        promise(static_cast<bool>(hash), "there is a hash");
        return *hash;
    }
    void same() const {
        std::uint64_t other = 0;
        promise(sunder_world_state_hash(&second_, &other) == SUNDER_OK && other == hash(),
                "the same calls give the same bits");
    }
    State bytes() const {
        Result<State> state = first_.saveState();
        promise(static_cast<bool>(state), "a world can be saved");
        return *state;
    }

    /// Whether it was accepted.
    template <class Call, class CallInC>
    bool both(const Call& call, const CallInC& callInC) {
        const State before = bytes();
        const Result<void> result = call(first_);
        const sunder_status status = callInC(&second_);
        promise(static_cast<bool>(result) == (status == SUNDER_OK), "both refuse or neither does");
        if (!result) {
            checkError(result.error());
            promise(result.error().message == sunder_message(), "both refuse for one reason");
            promise(bytes() == before, "what is refused changes nothing");
        }
        same();
        return static_cast<bool>(result);
    }

    void step(Input& input) {
        const bool wasWild = input.wild;
        double seconds = input.number(0, 24 * desc_.substep);
        if (seconds >= 0 && seconds <= 100) seconds = std::min(seconds, left_ * desc_.substep);
        const std::int64_t before = first_.substeps();
        both([&](World& w) { return w.step(seconds); },
             [&](sunder_world* w) { return sunder_world_step(w, seconds); });
        input.wild = wasWild;
        promise(first_.substeps() >= before, "time goes on");
        promise(seconds != 0 || first_.substeps() == before, "no time, no substep");
        left_ -= static_cast<double>(first_.substeps() - before);
        left_ = std::max(left_, 0.);
        look(input);
    }

    void save(const Input& input) {
        if (saves_.size() < kFewSaves) saves_.push_back({bytes(), hash(), input.wild});
    }

    bool restored(const State& state) {
        return both(
            [&](World& w) { return w.restoreState(state); },
            [&](sunder_world* w) { return sunder_world_restore(w, state.data(), state.size()); });
    }

    void restore(Input& input) {
        if (saves_.empty()) return;
        const Saved& saved = saves_[input.below(saves_.size())];
        if (!restored(saved.state)) {
            promise(saved.wild, "what was saved can be restored");
            return;
        }
        promise(hash() == saved.hash, "what is restored is what was saved");
        promise(bytes() == saved.state, "what is restored is saved as it was");
        input.wild = saved.wild;
    }

    void restoreChanged(Input& input) {
        State state = saves_.empty() || input.oneIn(8) ? strangersState()
                                                       : saves_[input.below(saves_.size())].state;
        const std::size_t choice = input.below(4);
        // Counted from either end, since what is at the ends is read first and last.
        const std::size_t at =
            (input.oneIn(2) ? input.below(48) : input.take<std::uint16_t>()) % state.size();
        const std::size_t place = input.oneIn(2) ? state.size() - 1 - at : at;
        if (choice == 0)
            state.resize(place);
        else if (choice == 1)
            state.insert(state.begin() + static_cast<std::ptrdiff_t>(place), std::byte{});
        else
            state[place] ^= static_cast<std::byte>(1 + input.below(255));
        promise(!restored(state), "changed bytes are refused");
    }

    void cast(Input& input) {
        const bool wasWild = input.wild;
        const Vec3 origin = input.vector(-2, 2), direction = input.vector(-1, 1);
        double from[3], along[3];
        put(origin, from);
        put(direction, along);
        const std::optional<RayHit> hit = first_.castRay(origin, direction);
        sunder_ray_hit inC;
        promise((sunder_world_cast_ray(&second_, from, along, &inC) != 0) == hit.has_value(),
                "C meets something where C++ does");
        if (hit) {
            promise((hit->object < 0) != (hit->body < 0), "a ray meets a cell or an object");
            promise(hit->body == inC.body && hit->object == inC.object, "C meets the same");
            promise(finite(origin) && finite(direction) && direction != Vec3{},
                    "a ray has a place and a direction");
            if (!wasWild) {
                promise(std::isfinite(hit->distance) && hit->distance >= 0 && finite(hit->place) &&
                            finite(hit->restPlace),
                        "a ray ends at a finite place");
                const Vec3& n = hit->normal;
                promise(std::abs(n.x * n.x + n.y * n.y + n.z * n.z - 1) < 1e-3,
                        "a normal has length 1");
            }
        }
        input.wild = wasWild;
    }

    void takeIncidents(Input& input) {
        if (input.oneIn(2)) {
            const sunder_incident* found = nullptr;
            sunder_world_incidents(&second_, &found);
            return;
        }
        for (const Incident& i : first_.incidents()) {
            promise(i.body >= 0 && i.body < static_cast<int>(desc_.bodies.size()),
                    "an incident is of a body");
            promise(i.material >= 0 && i.material < static_cast<int>(desc_.materials.size()),
                    "an incident is of a material");
            promise(i.object < static_cast<int>(desc_.objects.size()), "an object is there");
            promise(input.wild || (finite(i.place) && std::isfinite(i.impulse)),
                    "an incident is at a finite place");
        }
    }

    WorldDesc desc_;
    World first_;
    sunder_world second_;
    std::vector<Saved> saves_;
    double left_ = kFewSubsteps;
    bool gone_ = false;  ///< whether any body may not be there
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    const std::size_t calm = input.below(4);
    input.calm = calm != 0;
    const WorldDesc desc = described(input);
    input.calm = calm == 3;
    if (!small(desc)) return 0;
    WorldOptions options;
    options.threads = 1;
    options.settle = input.oneIn(8);
    options.incidents = static_cast<int>(input.below(64)) * 8;
    if (input.oneIn(4)) options.solver = "reference";
    if (input.oneIn(64)) options.threads = input.take<int>();
    if (options.threads > 2) return 0;
    if (input.oneIn(64)) options.incidents = input.take<std::int16_t>();
    Result<World> first = World::create(desc, options), second = World::create(desc, options);
    promise(static_cast<bool>(first) == static_cast<bool>(second), "both can be made or neither");
    if (!first) {
        checkError(first.error());
        return 0;
    }
    Twins twins(desc, std::move(*first), std::move(*second));
    for (int i = 0; i < kFewCalls && input.any(); ++i) twins.call(input);
    twins.look(input);
    return 0;
}
