#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "image/image.hpp"

/// A child process with its own environment, ended with its owner.
class Child {
  public:
    Child() = default;
    Child(const std::vector<std::string>& command, const std::map<std::string, std::string>& set,
          const std::filesystem::path& output);
    ~Child();
    Child(Child&&) noexcept;
    Child& operator=(Child&&) noexcept;

    bool running();
    void send(int signal) const;
    /// Waits up to so many seconds; −1: it still runs, 128 + n: signal n ended it.
    int wait(double seconds);
    /// Stops it until resume(), as a machine does that is busy with something else.
    void pause();
    void resume();

  private:
    pid_t pid_ = -1;
    int code_ = -1;
};

/// A screen without a monitor (Xvfb), with a mouse and a keyboard (xdotool).
class Screen {
  public:
    /// `dpi`: what its programs are told of its pixels.
    Screen(int width, int height, int dpi = 96);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    const std::string& display() const { return display_; }
    const std::filesystem::path& folder() const { return folder_; }  ///< for a test's files
    /// Starts a window manager (twm), without which windows cannot be minimised. F10 asks the
    /// window under the mouse to close, as its button would.
    void manageWindows();
    /// The keyboard's layout from now on, such as `fr`, whatever it was.
    void layOutKeyboard(const std::string& layout) const;
    /// xdotool with these arguments.
    void act(const std::string& arguments) const;
    /// What is on it now.
    sunder::image::Image picture() const;

  private:
    std::filesystem::path folder_;
    std::string display_;
    Child server_, manager_;
};

/// Waits for `condition`, but not longer than any sound machine takes.
template <class Condition>
bool eventually(Condition&& condition);

void sleepFor(double seconds);

/// Of a whole file; empty where there is none.
std::string textOf(const std::filesystem::path&);

template <class Condition>
bool eventually(Condition&& condition) {
    for (int i = 0; i < 2400; ++i) {
        if (condition()) return true;
        sleepFor(0.005);
    }
    return false;
}
