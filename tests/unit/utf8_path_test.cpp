#include "files/utf8_path.hpp"

#include <fstream>

#include "catch.hpp"
#include "support/test_folder.hpp"

using namespace sunder;

namespace fs = std::filesystem;

TEST_CASE("a path is made of UTF-8 and becomes UTF-8 again, on every system", "[files]") {
    for (const std::string text : {"", "wood.toml", "日本/Jürgen.toml", "a b/😀", "./../x", "/"}) {
        INFO(text);
        CHECK(files::utf8FromPath(files::pathFromUtf8(text)) == text);
    }
    // What the system gets is the letters, not their bytes one by one.
    CHECK(files::pathFromUtf8("日本").u16string() == u"日本");
    CHECK(files::pathFromUtf8("Jürgen").u32string() == U"J\u00fcrgen");
    CHECK(files::pathFromUtf8("日本/Jürgen.toml").stem() == fs::path(u"Jürgen"));
}

TEST_CASE("a file that was made by such a path has its name in the folder", "[files]") {
    const TestFolder folder;
    std::ofstream(folder.path() / files::pathFromUtf8("日本 Jürgen.toml")) << "a";
    const fs::directory_iterator found(folder.path());
    REQUIRE(found != fs::directory_iterator());
    CHECK(found->path().filename().u16string() == u"日本 Jürgen.toml");
    CHECK(files::utf8FromPath(found->path().filename()) == "日本 Jürgen.toml");
}

TEST_CASE("a path is shown with one kind of separator", "[files]") {
#ifdef _WIN32
    CHECK(files::utf8FromPath(files::pathFromUtf8("C:\\walls") / "wood" / "report.json") ==
          "C:/walls/wood/report.json");
#else
    // Here the other one is a letter like any, and what is no UTF-8 stays as it is.
    for (const std::string text : {"a\\b//c/", "\xff\xfe/\xe6"})
        CHECK(files::utf8FromPath(files::pathFromUtf8(text)) == text);
#endif
}
