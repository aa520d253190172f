#pragma once
#include <array>
#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "view/clock.hpp"
#include "view/event_log.hpp"
#include "view/measurements.hpp"
#include "view/orbit_camera.hpp"
#include "view/recorder.hpp"
#include "view/settings.hpp"
#include "view/shader_folder.hpp"
#include "view/stage.hpp"
#include "window/window.hpp"

namespace sunder::view {

/// What `sunder view` was started with.
struct Options {
    std::string scene = "wood";
    std::string solver;                  ///< empty: as last time
    std::filesystem::path folder = ".";  ///< where pictures, videos and files go
    std::filesystem::path shaders;       ///< empty: those compiled in
    std::filesystem::path log;           ///< empty: none
    int width = 0, height = 0;           ///< of the window; 0: as last time
};

/// Part of the window that shows the scene, in pixels of the framebuffer from its top left.
struct ViewArea {
    int left = 0, top = 0, width = 1, height = 1;
    bool contains(double x, double y) const {
        return x >= left && y >= top && x < left + width && y < top + height;
    }
    double aspect() const { return static_cast<double>(width) / height; }
};

/// Everything that panels, mouse and keys show and change. Its actions never throw for what a user
/// may do wrong: they say it in a message, and things stay as they were.
class Session {
  public:
    /// Throws InputError when the first scene cannot be shown.
    Session(window::Window&, const Options&, Settings);

    // --- scene and material ---
    void openScene(const std::string& nameOrPath);
    /// The scene with these changes, from its start.
    void buildScene(scene::Scene scene, const char* why);
    /// Another material in place of one of the scene's. The state is kept.
    void setMaterial(int index, const core::Material&);
    void newSeed();
    void saveScene(const std::string& name);
    void saveMaterial(int index, const std::string& name);
    /// As it was when the scene was opened.
    const scene::Scene& openedScene() const { return opened_; }
    const scene::Scene& scene() const { return stage->simulation.scene(); }
    /// s that the last change of the world took.
    double buildTime() const { return buildTime_; }
    /// Another number for each stage.
    int generation() const { return generation_; }
    /// Another number for each wall: materials change it not.
    int layout() const { return layout_; }

    // --- time ---
    void restart();
    void setSceneHits(bool);
    void setPaused(bool);
    void stepOnce(int steps);
    void setSpeed(double);

    // --- solver and view; panels change `settings` and say so by changed() ---
    void setSolver(const std::string&);
    void changed(const char* what, std::string_view value);
    void setFullScreen(bool);
    void setVsync(bool);
    void setSamples(int);

    // --- the camera ---
    /// Where the scene has it, as far back as it takes to see the wall.
    void lookHome();
    /// Once it is known how large the view is: the same where view or wall have another shape,
    /// unless the user has moved the camera.
    void keepHome();

    // --- hits ---
    /// Direction of what is at a place of the window.
    core::Vec3 rayAt(double x, double y) const;
    /// What the tool does at a spot, for `seconds` of simulated time where it goes on.
    void hit(const surface::Spot&, const core::Vec3& direction, double seconds);
    /// Reads the stress of what is there.
    void look(const surface::Spot&);
    /// 1 to 9, as on a keypad: the bodies' lower left to their upper right.
    void hitPreset(int number);
    std::vector<Push> takePushes() { return std::exchange(pushes_, {}); }

    // --- pictures ---
    void takePicture() { pictureWanted_ = true; }
    bool pictureWanted() const { return pictureWanted_; }
    void savePicture(image::Image);
    void toggleRecording();
    /// Says what has become of the video, and returns it.
    std::string endRecording();
    bool recording() const { return recorder_.has_value(); }
    const Recorder& recorder() const { return *recorder_; }
    void record(image::Image);

    /// Builds everything again when a shader changed.
    void watchShaders();
    const std::string& shaderError() const { return shaderError_; }

    // --- what is said ---
    struct Message {
        std::string text;
        bool problem;
        std::chrono::steady_clock::time_point until;
    };
    void say(const std::string& text, bool problem = false);
    const std::deque<Message>& messages() const { return messages_; }
    void forgetOldMessages();

    window::Window& window;
    Settings settings;
    EventLog log;
    Clock clock;
    OrbitCamera camera;
    std::unique_ptr<Stage> stage;
    Measurements measurements;
    ViewArea area;
    std::optional<int> lookedAt;           ///< cell whose stress is shown
    std::optional<surface::Spot> hovered;  ///< under the mouse
    bool help = false, measuring = false;  ///< shown
    bool everHit = false;
    std::filesystem::path folder;

  private:
    /// Does it, or says why it cannot be done. What ends the program, such as a lost context, is
    /// thrown all the same.
    template <class Action>
    bool attempt(Action&&);
    /// Replaces the stage, or says why not.
    bool rebuild(scene::Scene, const core::State*);
    std::unique_ptr<Stage> newStage(scene::Scene, const core::State*, const Stage* like);
    /// Says what the wall that stands now is not as its scene has it.
    void sayCompromises();
    /// Whether the file was written: it is new, or was written before, or is asked for again.
    bool save(const std::filesystem::path&, std::string_view bytes);
    /// Where pictures and videos of the scene go, less a number.
    std::filesystem::path unnumbered(const char* ending) const;
    void addLegend(image::Image&) const;
    /// Moves the video to its name. Returns what has become of it. Throws InputError.
    std::string finishRecording();
    void dropRecorder();
    /// Builds everything with the folder's shaders, or says why not.
    void tryShaders();

    /// Whether the scene's file has its camera for the walls as they are.
    bool composed() const;

    scene::Scene opened_;
    double buildTime_ = 0;
    int generation_ = 0, layout_ = 0;
    std::array<int, 3> homeFor_{};  ///< width and height of the view, and layout
    std::vector<Push> pushes_;
    bool pictureWanted_ = false;
    std::optional<Recorder> recorder_;
    std::optional<ShaderFolder> shaders_;
    gl::ShaderSource soundShaders_ = gl::embeddedShaders();  ///< the last that worked
    std::string shaderError_;
    std::set<std::filesystem::path> ownFiles_;  ///< that may be replaced
    std::deque<Message> messages_;
};

}  // namespace sunder::view
