#pragma once
#include <functional>
#include <vector>

#include "core/rest_islands.hpp"

namespace sunder::core {

/// What a solver knows of the bodies of its world as wholes: which are there, which it has, whose
/// anchors have let go, and which of them, and of the objects, sleep (core/sleep.hpp). The book
/// alone: what follows for arrays and textures is up to the solver, which is told what changed.
class BodyBook {
  public:
    /// All bodies are there, held and awake. `world` must outlive it.
    explicit BodyBook(const World& world);

    /// Whether a body is in the world, whoever has it.
    bool present(int body) const { return present_[body]; }
    /// Whether this solver has it, be it there or not (core/body_host.hpp).
    bool holds(int body) const { return held_[body]; }
    bool holdsAny() const;
    /// Whether this solver has it and it is there.
    bool active(int body) const { return held_[body] && present_[body]; }
    bool asleep(int body) const { return active(body) && sleepers_.asleep(memberOfBody(body)); }
    bool awake(int body) const { return active(body) && !asleep(body); }
    bool objectAsleep(int object) const { return sleepers_.asleep(memberOfObject(world_, object)); }
    /// Whether its anchors have let go.
    bool released(int body) const { return released_[body]; }
    /// Bodies that are not there, ascending.
    std::vector<int> absent() const;
    /// Bodies whose anchors have let go, ascending.
    std::vector<int> released() const;
    std::vector<int> activeBodies() const;
    std::vector<int> awakeBodies() const;

    /// Of a body that is awake: it is there, as it was described, or not.
    void setPresent(int body, bool present) {
        present_[body] = present;
        released_[body] = false;
    }
    /// Likewise.
    void setHeld(int body, bool held) { held_[body] = held; }
    /// Whether that changed anything: it is there, has anchors, and they had not let go.
    bool releaseAnchors(int body);
    /// Takes over what a state says of bodies as wholes.
    void follow(const State& state);
    /// Puts it into a state.
    void describe(State& state) const;

    /// Some bodies and objects, each ascending.
    struct Members {
        std::vector<int> bodies, objects;
    };
    /// Wakes a body or an object (memberOfBody(), memberOfObject()) and what sleeps with it: those
    /// that slept.
    Members wake(int member);
    void wakeAll() { sleepers_.wakeAll(); }
    /// Wakes a body that comes or goes, and what sleeps where its boxes are: those that slept.
    /// addBoxes: adds those of bodies that sleep. objects: as they are.
    using AddBoxes = std::function<void(std::vector<RestBox>&)>;
    Members wakeAround(int body, const std::vector<RestBox>& own, const AddBoxes& addBoxes,
                       const std::vector<ObjectState>& objects);
    /// Lets islands fall asleep all of which have been calm for long enough: those that now sleep.
    /// ready: whether a body has been. addBoxes: adds those of active bodies. ofObject: what an
    /// object is to others' rest; objects: as they are.
    Members settle(const std::function<bool(int body)>& ready, const AddBoxes& addBoxes,
                   const std::function<RestIslands::Status(int object)>& ofObject,
                   const std::vector<ObjectState>& objects);

    /// Which bodies are there, and whose anchors have let go. Nobody sleeps by then, or
    /// archiveSleepers() follows. Which are active by what is archived, for the rest of it.
    std::vector<bool> archiveBodies(Archive& archive);
    void archiveSleepers(Archive& archive, const std::vector<bool>& active);

  private:
    Members split(const std::vector<int>& members) const;
    template <class Choice>
    std::vector<int> chosen(const Choice& choice) const;

    const World& world_;
    std::vector<bool> present_, held_, released_;
    RestIslands sleepers_;
};

}  // namespace sunder::core
