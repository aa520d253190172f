// Files that are written whole or not at all, under names that nobody else gets, and signals that
// wait for it.
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <thread>

#include "catch.hpp"
#include "core/types.hpp"
#include "files/held_signals.hpp"
#include "files/temporary_file.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "support/test_folder.hpp"

namespace fs = std::filesystem;
using namespace sunder;
using namespace sunder::core;

namespace {

std::set<std::string> entries(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(files::utf8FromPath(entry.path().filename()));
    return names;
}

/// Eight at once.
void together(const std::function<void(int)>& action) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) threads.emplace_back(action, i);
    for (std::thread& thread : threads) thread.join();
}

std::atomic<int> lastSignal = 0, signalCount = 0;

/// Signals do nothing but this while it lives.
class SignalRecord {
  public:
    SignalRecord() : before_{std::signal(SIGINT, take), std::signal(SIGTERM, take)} {
        lastSignal = signalCount = 0;
    }
    ~SignalRecord() {
        std::signal(SIGINT, before_[0]);
        std::signal(SIGTERM, before_[1]);
    }

  private:
    static void take(int signal) {
        lastSignal = signal;
        ++signalCount;
    }
    void (*before_[2])(int);
};

}  // namespace

TEST_CASE("Files get the first number that nothing has", "[files]") {
    const TestFolder folder;
    const fs::path named = folder.path() / "a.wood.png";
    std::ofstream(folder.path() / "a.wood-001.png") << "mine";
    fs::create_directory(folder.path() / "a.wood-003.png");
    CHECK(files::writeNumberedFile(named, "x") == folder.path() / "a.wood-002.png");
    CHECK(files::writeNumberedFile(named, "y") == folder.path() / "a.wood-004.png");
    CHECK(contents(folder.path() / "a.wood-001.png") == "mine");
    CHECK(contents(folder.path() / "a.wood-002.png") == "x");
    CHECK(entries(folder.path()).size() == 4);
}

TEST_CASE("However many want a number at once, each gets one of its own and none is lost",
          "[files]") {
    const TestFolder folder;
    constexpr int kEach = 25;
    together([&](int who) {
        for (int i = 0; i < kEach; ++i)
            files::writeNumberedFile(folder.path() / "wood.png",
                                     std::to_string(who) + "," + std::to_string(i));
    });
    std::set<std::string> kept;
    for (const std::string& name : entries(folder.path()))
        kept.insert(contents(folder.path() / name));
    CHECK(kept.size() == 8 * kEach);
    // No number was left out, and nothing else is there.
    CHECK(entries(folder.path()).size() == 8 * kEach);
    CHECK(fs::exists(folder.path() / "wood-200.png"));
}

TEST_CASE("Of many that make a new file at once, one does, and nobody replaces it", "[files]") {
    const TestFolder folder;
    std::atomic<int> wrote = 0;
    std::string winner[8];
    together([&](int who) {
        winner[who] = std::to_string(who);
        if (files::writeNewFile(folder.path() / "a.toml", winner[who]))
            ++wrote;
        else
            winner[who].clear();
    });
    CHECK(wrote == 1);
    std::string all;
    for (const std::string& one : winner) all += one;
    CHECK(contents(folder.path() / "a.toml") == all);
    CHECK(entries(folder.path()) == std::set<std::string>{"a.toml"});
}

TEST_CASE("Whether a file can be written is tried, and leaves no trace", "[files]") {
    const TestFolder folder;
    const fs::path here = folder.path();
    std::ofstream(here / "file") << "mine";
    fs::create_directory(here / "folder.json");
    const std::set<std::string> before = entries(here);
    files::checkWritable("");
    files::checkWritable(here / "new.json");
    files::checkWritable(here / "file");
    const std::string tooLong(300, 'a');
    struct Case {
        fs::path path;
        std::string said;
    };
    for (const Case& c :
         {Case{here / "none" / "a.json", "there is no folder '"},
          Case{here / "file" / "a.json", "is not a folder"},
          Case{here / "folder.json", "it is a folder"}, Case{here / "", "it is a folder"},
          Case{here / tooLong, "cannot be written: "}}) {
        INFO(files::utf8FromPath(c.path));
        CHECK_THROWS_WITH(
            files::checkWritable(c.path),
            Catch::StartsWith(files::utf8FromPath(c.path) + ": cannot be written: ") &&
                Catch::Contains(c.said));
        CHECK_THROWS_AS(files::writeFile(c.path, "x"), InputError);  // it was right
    }
#ifdef __linux__
    // A folder in which nobody can make a file, whatever its permissions say.
    CHECK_THROWS_WITH(files::checkWritable("/proc/a.json"), Catch::Contains("cannot be written: "));
    files::checkWritable("/dev/null");
#endif
    CHECK(entries(here) == before);
    CHECK(contents(here / "file") == "mine");
}

#ifndef _WIN32
TEST_CASE("A pipe is no place to try", "[files]") {
    const TestFolder folder;
    const std::string pipe = (folder.path() / "pipe").string();
    REQUIRE(std::system(("mkfifo '" + pipe + "'").c_str()) == 0);
    files::checkWritable(pipe);  // else this would wait for a reader for ever
    CHECK(fs::is_fifo(pipe));
}
#endif

TEST_CASE("A signal waits for as long as it is held, and is then as if it came only now",
          "[files]") {
    const SignalRecord record;
    {
        const files::HeldSignals outer;
        CHECK_FALSE(files::signalledAgain());
        {
            const files::HeldSignals inner;
            CHECK(files::notedSignal() == 0);
            std::raise(SIGTERM);
            CHECK(files::notedSignal() == SIGTERM);
            CHECK_FALSE(files::signalledAgain());
        }
        std::raise(SIGINT);
        CHECK(files::notedSignal() == SIGTERM);
        CHECK(files::signalledAgain());
        CHECK(signalCount == 0);
    }
    CHECK(signalCount == 1);
    CHECK(lastSignal == SIGTERM);
    CHECK(files::notedSignal() == 0);
    CHECK_FALSE(files::signalledAgain());
    std::raise(SIGINT);
    CHECK(lastSignal == SIGINT);
}

TEST_CASE("Signals that came before anybody looked are one wish", "[files]") {
    const SignalRecord record;
    files::HeldSignals held;
    for (int i = 0; i < 3; ++i) std::raise(SIGINT);
    CHECK_FALSE(files::signalledAgain());
    CHECK_FALSE(files::signalledAgain());
    std::raise(SIGINT);
    CHECK(files::signalledAgain());
    held.answer();
    CHECK_FALSE(files::signalledAgain());
}

TEST_CASE("A signal that was answered is not raised, one that was ignored is ignored still",
          "[files]") {
    const SignalRecord record;
    {
        files::HeldSignals held;
        std::raise(SIGINT);
        CHECK(files::exitCodeOf(files::notedSignal()) == 130);
        held.answer();
    }
    CHECK(signalCount == 0);

    std::signal(SIGINT, SIG_IGN);
    {
        const files::HeldSignals held;
        std::raise(SIGINT);
        CHECK(files::notedSignal() == 0);
    }
    CHECK(std::signal(SIGINT, SIG_IGN) == SIG_IGN);
}

TEST_CASE("A signal while a file is being made finds nothing of it", "[files]") {
    const TestFolder folder;
    static fs::path place;
    static bool empty = false;
    place = folder.path();
    const auto before = std::signal(
        SIGTERM, [](int) { empty = fs::directory_iterator(place) == fs::directory_iterator(); });
    {
        files::TemporaryFile file(folder.path() / "a.json");
        file.make();
        std::raise(SIGTERM);
        CHECK(entries(folder.path()).size() == 1);
        CHECK_FALSE(empty);
    }
    CHECK(empty);
    std::signal(SIGTERM, before);
}
