#include "image/image.hpp"

#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "catch.hpp"
#include "core/types.hpp"
#include "files/write_file.hpp"
#include "support/test_folder.hpp"

namespace fs = std::filesystem;
using namespace sunder;
using namespace sunder::core;

namespace {

/// An empty folder that goes away with the test.
class Folder {
  public:
    Folder() {
        std::random_device random;
        path_ = fs::temp_directory_path() / ("sunder-image-test-" + std::to_string(random()));
        fs::create_directory(path_);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
    }

  private:
    fs::path path_;
};

image::Image noise(int width, int height) {
    image::Image image{width, height, {}};
    std::minstd_rand random(7);
    for (int i = 0; i < 3 * width * height; ++i)
        image.pixels.push_back(static_cast<std::uint8_t>(random() >> 8));
    return image;
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the InputError that `action` must throw.
template <class Action>
std::string errorOf(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    FAIL("no InputError");
    return {};
}

bool mentions(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("A PNG comes back as it was written", "[image]") {
    const Folder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {131, 67}, {1, 300}}) {
        CAPTURE(width, height);
        const image::Image image = noise(width, height);
        image::writePng(folder / "a.png", image);
        const image::Image back = image::readPng(folder / "a.png");
        CHECK(back.width == width);
        CHECK(back.height == height);
        CHECK(back.pixels == image.pixels);
    }
    CHECK(folder.entries() == 1);
}

TEST_CASE("Writing replaces a file whole", "[image]") {
    const Folder folder;
    write(folder / "a.txt", "something longer than what follows");
    files::writeFile(folder / "a.txt", std::string_view("a\0b", 3));
    CHECK(contents(folder / "a.txt") == std::string("a\0b", 3));
    files::writeFile(folder / "empty", "");
    CHECK(fs::file_size(folder / "empty") == 0);
    CHECK(folder.entries() == 2);
}

TEST_CASE("Files that are no PNG are refused by name", "[image]") {
    const Folder folder;
    image::writePng(folder / "good.png", noise(40, 30));
    const std::string good = contents(folder / "good.png");

    CHECK(mentions(errorOf([&] { image::readPng(folder / "missing.png"); }),
                   "missing.png: no such file"));
    CHECK(mentions(errorOf([&] { image::readPng(folder / ""); }), "not a file"));
    for (const std::string& bytes :
         {std::string(), std::string("P6 1 1 255 abc"), good.substr(0, 7)}) {
        write(folder / "bad.png", bytes);
        CHECK(mentions(errorOf([&] { image::readPng(folder / "bad.png"); }), "bad.png: not a PNG"));
    }
    for (const std::size_t length : {good.size() / 2, good.size() - 12}) {
        CAPTURE(length);
        write(folder / "cut.png", good.substr(0, length));
        CHECK(mentions(errorOf([&] { image::readPng(folder / "cut.png"); }),
                       "cut.png: a damaged PNG"));
    }
}

TEST_CASE("A PNG of absurd size is refused before memory is asked for", "[image]") {
    const Folder folder;
    image::writePng(folder / "a.png", noise(4, 4));
    std::string bytes = contents(folder / "a.png");
    // Width and height are big-endian words at 16 and 20; stb reads no checksums.
    bytes.replace(16, 8, std::string("\0\1\0\0\0\0\4\1", 8));  // 65536 x 1025
    write(folder / "huge.png", bytes);
    const std::string error = errorOf([&] { image::readPng(folder / "huge.png"); });
    CHECK(mentions(error, "huge.png"));
    CHECK(mentions(error, "65536 x 1025"));
}

TEST_CASE("A failed write says why and leaves nothing behind", "[image]") {
    const Folder folder;
    const image::Image image = noise(3, 3);

    const std::string missing = errorOf([&] { image::writePng(folder / "nowhere/a.png", image); });
    CHECK(mentions(missing, "nowhere"));
    CHECK(mentions(missing, "does not exist"));
    CHECK(folder.entries() == 0);

    fs::create_directory(folder / "taken");
    write(folder / "taken/inside", "kept");
    const std::string taken = errorOf([&] { image::writePng(folder / "taken", image); });
    CHECK(mentions(taken, "taken"));
    CHECK(mentions(taken, "folder"));
    CHECK(contents(folder / "taken/inside") == "kept");
    CHECK(folder.entries() == 1);

    // A name that is too long for any file system, so that opening the temporary file itself fails.
    CHECK(mentions(errorOf([&] { image::writePng(folder / std::string(400, 'x'), image); }),
                   "cannot be written"));
    CHECK(folder.entries() == 1);
}
