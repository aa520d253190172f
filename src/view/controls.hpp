#pragma once
#include "view/every.hpp"
#include "view/interface.hpp"
#include "view/session.hpp"

namespace sunder::view {

/// What mouse and keyboard do outside the panels.
class Controls {
  public:
    /// Once a frame, before time moves; `elapsed`: s since the last one. False: the user quits.
    bool handle(Session&, const Interface&, double elapsed);
    /// Pushes that go on while a button is held, for `seconds` of simulated time.
    void holdHits(Session&, double seconds);

  private:
    enum class Drag { None, Hit, Orbit, Pan };

    bool handleKeys(Session&, const Interface&, double elapsed);
    void handleMouse(Session&, const Interface&);
    void press(Session&, const gl::Input::Click&);
    void lookAt(Session&, double x, double y);
    void hit(Session&, double x, double y);

    Drag drag_ = Drag::None;
    bool released_ = false;  ///< no button is held any more, since the last frame
    double sinceShot_ = 0;   ///< s
    int sinceLook_ = 0;      ///< frames since the spot under a resting mouse was sought
    Every hovering_{0, 0.05};
};

}  // namespace sunder::view
