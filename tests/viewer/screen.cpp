#include "screen.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>

namespace fs = std::filesystem;

namespace {

/// In a shell.
void run(const std::string& command) {
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

}  // namespace

void sleepFor(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

std::string textOf(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

Child::Child(const std::vector<std::string>& command, const std::map<std::string, std::string>& set,
             const fs::path& output) {
    // Everything that allocates comes before fork().
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    signal(SIGINT, SIG_DFL);  // not ignored, whatever started these tests ignores
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    for (const auto& [name, value] : set) {
        if (value.empty())
            unsetenv(name.c_str());
        else
            setenv(name.c_str(), value.c_str(), 1);
    }
    execvp(arguments[0], arguments.data());
    _exit(127);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), code_(std::exchange(other.code_, -1)) {}

Child& Child::operator=(Child&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(code_, other.code_);
    return *this;
}

Child::~Child() {
    if (!running()) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

bool Child::running() {
    if (pid_ < 0 || code_ >= 0) return false;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) != pid_) return true;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return false;
}

void Child::send(int signal) const {
    kill(pid_, signal);
}

int Child::wait(double seconds) {
    for (double waited = 0; running() && waited < seconds; waited += 0.05) sleepFor(0.05);
    return code_;
}

void Child::pause() {
    int status = 0;
    if (kill(pid_, SIGSTOP) != 0 || waitpid(pid_, &status, WUNTRACED) != pid_ ||
        !WIFSTOPPED(status))
        throw std::runtime_error("the program cannot be stopped: it has ended");
}

void Child::resume() {
    kill(pid_, SIGCONT);
}

Screen::Screen(int width, int height, int dpi) {
    std::string name = (fs::temp_directory_path() / "sunder-screen-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
    const fs::path number = folder_ / "display";
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    // The server writes the number of the display that it found free.
    server_ = Child({"sh", "-c",
                     "exec Xvfb -displayfd 3 -noreset -nolisten tcp -fbdir '" + folder_.string() +
                         "' -screen 0 " + size + " 3>'" + number.string() + "'"},
                    {}, folder_ / "xvfb.log");
    const bool up = eventually([&] {
        std::ifstream file(number);
        std::string text;
        if (!std::getline(file, text) || text.empty()) return !server_.running();
        display_ = ":" + text;
        return true;
    });
    if (!up || display_.empty()) throw std::runtime_error("Xvfb does not start; is it installed?");
    // Where a desktop leaves it for every program.
    if (dpi != 96)
        run("printf 'Xft.dpi: " + std::to_string(dpi) + "\\n' | DISPLAY=" + display_ +
            " xrdb -nocpp -merge");
}

Screen::~Screen() {
    manager_ = Child();
    server_ = Child();
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void Screen::act(const std::string& arguments) const {
    run("DISPLAY=" + display_ + " xdotool " + arguments);
}

void Screen::layOutKeyboard(const std::string& layout) const {
    run("DISPLAY=" + display_ + " setxkbmap " + layout);
}

void Screen::manageWindows() {
    const fs::path settings = folder_ / "twmrc";
    // It asks nobody where a window should go, and needs no fonts but the server's own.
    std::ofstream file(settings);
    file << "RandomPlacement\nNoTitle\n\"F10\" = : all : f.delete\n";
    for (const char* what : {"Title", "Resize", "Menu", "Icon", "IconManager"})
        file << what << "Font \"fixed\"\n";
    file.close();
    manager_ = Child({"twm", "-f", settings.string()}, {{"DISPLAY", display_}, {"LC_ALL", "C"}},
                     folder_ / "twm.log");
}

sunder::image::Image Screen::picture() const {
    // The server's framebuffer lies in a file in the format of xwd: a header of 32-bit numbers,
    // most significant byte first, colours, then rows of blue, green, red and a spare byte.
    std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    const auto field = [&](std::size_t index) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | static_cast<std::uint8_t>(bytes.at(4 * index + i));
        return value;
    };
    const std::uint32_t header = field(0), width = field(4), height = field(5);
    const std::uint32_t rowBytes = field(12), colours = field(19);
    if (field(11) != 32) throw std::runtime_error("the screen's pixels do not have 32 bits");
    sunder::image::Image image{static_cast<int>(width), static_cast<int>(height), {}};
    image.pixels.reserve(std::size_t{3} * width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            for (const std::size_t channel : {2, 1, 0})
                image.pixels.push_back(static_cast<std::uint8_t>(
                    bytes.at(header + 12 * colours + y * rowBytes + 4 * x + channel)));
    return image;
}
