#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

#include "core/types.hpp"
#include "files/held_signals.hpp"
#include "image/fed_process.hpp"

extern char** environ;

namespace sunder::image {

using namespace core;

struct FedProcess::System {
    // A program that ends early is no reason for this one to die without a word.
    void (*pipeHandler)(int) = std::signal(SIGPIPE, SIG_IGN);
    int input = -1, process = -1;
};

namespace {

[[noreturn]] void fail(const std::string& program, int error) {
    throw InputError("cannot start " + program + ": " + std::generic_category().message(error));
}

}  // namespace

FedProcess::FedProcess(const std::vector<std::string>& command)
    : system_(std::make_unique<System>()) {
    // A file, not a pipe: nobody has to read it while frames are fed.
    errors_ = std::tmpfile();
    int ends[2];
    if (!errors_ || pipe(ends) != 0) fail(command.front(), errno);
    // Else the other program would hold its own input open.
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    // Errors first: their file is number 0 where this program's own input was closed.
    posix_spawn_file_actions_adddup2(&files, fileno(errors_), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t pipes;
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &pipes);
    // A group of its own: Ctrl+C in a terminal goes to all of this program's, and it is for this
    // program to say when the other one ends.
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t process = -1;
    const int error =
        posix_spawnp(&process, words.front(), &files, &attributes, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    ::close(ends[0]);
    if (error) ::close(ends[1]);
    // A folder of PATH that cannot be searched (EACCES) has no such program either.
    if (error == ENOENT || error == EACCES || error == ENOTDIR) return;
    if (error) fail(command.front(), error);
    system_->process = process;
    system_->input = ends[1];
    // So that one which has stopped reading can be given up.
    fcntl(system_->input, F_SETFL, O_NONBLOCK);
    started_ = true;
}

FedProcess::~FedProcess() {
    close();
    if (errors_) std::fclose(errors_);
    std::signal(SIGPIPE, system_->pipeHandler);
}

bool FedProcess::feed(std::string_view bytes) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kPatience(50);  // until a look at signals
    auto fed = Clock::now();
    while (!bytes.empty()) {
        if (givenUp_) return false;
        const ssize_t written = write(system_->input, bytes.data(), bytes.size());
        if (written < 0 && errno == EAGAIN) {
            pollfd room{system_->input, POLLOUT, 0};
            poll(&room, 1, static_cast<int>(kPatience.count()));
            if (Clock::now() - fed > kPatience) giveUp();
            continue;
        }
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
        fed = Clock::now();
    }
    return true;
}

bool FedProcess::close() {
    if (system_->input < 0) return false;
    giveUp();
    ::close(std::exchange(system_->input, -1));
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(system_->process, &status, WNOHANG);
        if (ended == system_->process) break;
        if (ended < 0 && errno != EINTR) return false;
        // A signal would not end the waiting itself: std::signal has the system go on with it.
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        giveUp();
    }
    return !givenUp_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void FedProcess::giveUp() {
    if (givenUp_ || !files::signalledAgain()) return;
    givenUp_ = true;
    kill(-system_->process, SIGKILL);
}

}  // namespace sunder::image
