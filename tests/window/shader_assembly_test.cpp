#include "gl/shader_assembly.hpp"

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"

using namespace sunder::gl;

namespace {

ShaderSource sourceOf(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> std::optional<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return found->second;
    };
}

struct Place {
    std::string file;
    int line = 0;
};

/// Where a compiler that obeys #line would say that `needle` stands.
Place placeOf(const std::string& text, const std::string& needle,
              const std::vector<std::string>& files) {
    std::istringstream lines(text);
    Place place;
    for (std::string line; std::getline(lines, line); ++place.line) {
        int number = 0;  // 10000 per file
        std::size_t file = 0;
        if (std::sscanf(line.c_str(), "#line %d %zu", &number, &file) == 2)
            place = {files.at(file), number % 10000 - 1};
        else if (line.find(needle) != std::string::npos)
            return place;
    }
    return {"not found", 0};
}

int occurrences(const std::string& text, const std::string& needle) {
    int count = 0;
    for (auto at = text.find(needle); at != std::string::npos; at = text.find(needle, at + 1))
        ++count;
    return count;
}

/// What assembleShader() throws.
std::string failure(const ShaderSource& source, const std::string& name) {
    std::vector<std::string> files;
    try {
        assembleShader(source, name, {}, files);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing thrown";
}

}  // namespace

TEST_CASE("A shader begins with its version, then the defines in order") {
    std::vector<std::string> files;
    const std::string text =
        assembleShader(sourceOf({{"a.vert", "void main() {}"}}), "a.vert",
                       {{"LAWS", "3"}, {"EMPTY", ""}, {"WIDTH", "LAWS"}}, files);
    CHECK(text.starts_with("#version 410 core\n"));
    const auto laws = text.find("#define LAWS 3\n");
    const auto empty = text.find("#define EMPTY \n");
    const auto width = text.find("#define WIDTH LAWS\n");
    const auto body = text.find("void main() {}\n");
    REQUIRE(body != std::string::npos);
    CHECK(laws < empty);
    CHECK(empty < width);
    CHECK(width < body);
}

TEST_CASE("A file is included once, wherever it is asked for") {
    const ShaderSource source = sourceOf({{"main.vert",
                                           "#include \"a.glsl\"\n"
                                           "  #  include \"b.glsl\" // twice\n"
                                           "#include \"a.glsl\"\n"
                                           "#include \"main.vert\"\n"
                                           "main_text\n"},
                                          {"a.glsl", "#pragma once\n#include \"b.glsl\"\na_text\n"},
                                          {"b.glsl", "#include \"a.glsl\"\nb_text"}});
    std::vector<std::string> files;
    const std::string text = assembleShader(source, "main.vert", {}, files);
    CHECK(occurrences(text, "a_text") == 1);
    CHECK(occurrences(text, "b_text") == 1);
    CHECK(occurrences(text, "main_text") == 1);
    CHECK(occurrences(text, "include") == 0);
    CHECK(occurrences(text, "pragma") == 0);
    // What is included stands before what needs it.
    CHECK(text.find("b_text") < text.find("a_text"));
    CHECK(text.find("a_text") < text.find("main_text"));
}

TEST_CASE("#line directives lead back to each file's own lines") {
    const ShaderSource source = sourceOf({{"main.vert",
                                           "first\n"
                                           "#include \"a.glsl\"\n"
                                           "third\n"
                                           "#include \"a.glsl\"\n"
                                           "fifth\n"},
                                          {"a.glsl",
                                           "// top\n"
                                           "#include \"b.glsl\"\n"
                                           "a_three\r\n"
                                           "a_four"},
                                          {"b.glsl", "\n\nb_three"}});
    std::vector<std::string> files;
    const std::string text = assembleShader(source, "main.vert", {{"D", "defined_here"}}, files);
    const auto check = [&](const char* needle, const char* file, int line) {
        INFO(needle << " in\n" << text);
        const Place place = placeOf(text, needle, files);
        CHECK(place.file == file);
        CHECK(place.line == line);
    };
    check("defined_here", "(defines)", 1);
    check("first", "main.vert", 1);
    check("third", "main.vert", 3);
    check("fifth", "main.vert", 5);
    check("a_three", "a.glsl", 3);
    check("a_four", "a.glsl", 4);
    check("b_three", "b.glsl", 3);
}

TEST_CASE("Two stages that share the list of files keep their numbers apart") {
    const ShaderSource source = sourceOf({{"v.vert", "in_vertex\n"}, {"f.frag", "in_fragment\n"}});
    std::vector<std::string> files;
    const std::string vertex = assembleShader(source, "v.vert", {}, files);
    const std::string fragment = assembleShader(source, "f.frag", {}, files);
    CHECK(placeOf(vertex, "in_vertex", files).file == "v.vert");
    CHECK(placeOf(fragment, "in_fragment", files).file == "f.frag");
}

TEST_CASE("An include in a comment is text, one in angle brackets is the C++ compiler's") {
    const ShaderSource source = sourceOf({{"a.vert",
                                           "// #include \"no.glsl\"\n"
                                           "/* as in\n"
                                           "#include \"no.glsl\"\n"
                                           "*/ int a; // not open: /*\n"
                                           "#include \"yes.glsl\"\n"
                                           "#ifdef __cplusplus\n"
                                           "#include <cstdint>\n"
                                           "#endif\n"},
                                          {"yes.glsl", "yes_text\n"}});
    std::vector<std::string> files;
    const std::string text = assembleShader(source, "a.vert", {}, files);
    CHECK(occurrences(text, "#include \"no.glsl\"") == 2);
    CHECK(occurrences(text, "#include <cstdint>") == 1);
    CHECK(occurrences(text, "yes_text") == 1);
}

TEST_CASE("What cannot be assembled is named with file and line") {
    const ShaderSource source = sourceOf({{"main.vert", "\n#include \"a.glsl\"\n"},
                                          {"a.glsl", "int a;\n\n#include \"gone.glsl\"\n"},
                                          {"versioned.vert", "// a comment\n#version 330\n"}});
    const std::string missing = failure(source, "main.vert");
    CHECK(missing.find("a.glsl:3: ") == 0);
    CHECK(missing.find("\"gone.glsl\"") != std::string::npos);
    CHECK(failure(source, "versioned.vert").find("versioned.vert:2: #version") == 0);
    CHECK(failure(source, "nowhere.vert").find("nowhere.vert") != std::string::npos);
}

TEST_CASE("A driver's log names files") {
    const std::vector<std::string> files{"(defines)", "main.vert", "physics/law.glsl"};
    SECTION("Mesa") {
        CHECK(
            nameFilesInLog("2:20012(5): error: `x' undeclared\n1:10003(1): warning: y\n", files) ==
            "physics/law.glsl:12(5): error: `x' undeclared\nmain.vert:3(1): warning: y");
    }
    SECTION("Mesa, which loses the source-string number") {
        CHECK(nameFilesInLog("0:20012(5): error", files) == "physics/law.glsl:12(5): error");
    }
    SECTION("NVIDIA") {
        CHECK(nameFilesInLog("2(20012) : error C1503: undefined variable \"x\"", files) ==
              "physics/law.glsl(12) : error C1503: undefined variable \"x\"");
    }
    SECTION("Apple, AMD, Intel") {
        CHECK(nameFilesInLog("ERROR: 1:10007: 'x' : undeclared identifier", files) ==
              "ERROR: main.vert:7: 'x' : undeclared identifier");
    }
    SECTION("Lines without a position, and numbers that are no file, stay") {
        const std::string log =
            "Vertex info\n-----------\n3:30001(1): error\n0:99999999999(1): error";
        CHECK(nameFilesInLog(log, files) == log);
    }
}

TEST_CASE("The shaders under glsl/ are compiled in") {
    const std::optional<std::string> layout = embeddedShaders()("shared/layout.h");
    REQUIRE(layout);
    CHECK(layout->find("#define SUNDER_CELL_LAW") != std::string::npos);
    // Not only ASCII survives.
    CHECK(layout->find("λ") != std::string::npos);
    CHECK_FALSE(embeddedShaders()("shared/gone.h"));
}
