#pragma once
#include <optional>
#include <set>
#include <vector>

#include "view/every.hpp"
#include "view/interface.hpp"
#include "view/session.hpp"

namespace sunder::view {

/// What mouse and keyboard do outside the panels.
class Controls {
  public:
    /// Once a frame, before the rest; `elapsed`: s since the last one.
    void begin(double elapsed);
    /// Something that mouse or keyboard did, in order; a press, a release, the wheel or a key after
    /// panels have begun a frame with it. False: the user quits.
    bool take(Session&, const Interface&, const window::InputEvent&);
    /// What goes on as long as something is held, and where the mouse is now. After all of that,
    /// before time moves.
    void goOn(Session&, const Interface&, double elapsed);
    /// Pushes that go on while a button is held, for `seconds` of simulated time.
    void holdHits(Session&, double seconds);

  private:
    enum class Drag { None, Hit, Orbit, Pan };
    /// Where a button went down.
    struct Aim {
        surface::Spot spot;
        core::Vec3 direction;
    };

    void move(Session&, const window::InputEvent&);
    void press(Session&, const window::InputEvent&);
    void release(const window::InputEvent&);
    void fly(Session&, double elapsed) const;
    void lookAt(Session&, double x, double y);
    void hit(Session&, double x, double y);

    Drag drag_ = Drag::None;
    window::MouseButton button_{};  ///< that holds it
    std::optional<Aim> aim_;        ///< of a drag that began in this frame
    std::vector<Aim> taps_;         ///< of those that ended in it, too
    std::set<window::Key> tapped_;  ///< keys that went down in this frame
    bool moved_ = false;            ///< in this frame, the mouse
    double sinceShot_ = 0;          ///< s
    int sinceLook_ = 0;             ///< frames since the spot under a resting mouse was sought
    Every hovering_{0, 0.05};
};

}  // namespace sunder::view
