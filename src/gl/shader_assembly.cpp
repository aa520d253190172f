#include "gl/shader_assembly.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <regex>
#include <stdexcept>

#include "embedded_shaders.hpp"

namespace sunder::gl {

using namespace core;

namespace {

constexpr std::size_t kLinesPerFile = 10000;

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// The words after '#', when `line` is a directive: `include "a"` for `  #  include "a"`.
std::optional<std::string_view> directive(std::string_view line) {
    line = trimmed(line);
    if (line.empty() || line.front() != '#') return std::nullopt;
    return trimmed(line.substr(1));
}

std::optional<std::string_view> quotedInclude(std::string_view directive) {
    if (!directive.starts_with("include")) return std::nullopt;
    const std::string_view rest = trimmed(directive.substr(7));
    if (rest.empty() || rest.front() != '"') return std::nullopt;
    const auto end = rest.find('"', 1);
    if (end == std::string_view::npos) return std::nullopt;
    return rest.substr(1, end - 1);
}

/// Whether a block comment is open after `line`, given whether one was before.
bool inCommentAfter(std::string_view line, bool inComment) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const std::string_view two = line.substr(i, 2);
        if (!inComment && two == "//") return false;
        if (two != (inComment ? "*/" : "/*")) continue;
        inComment = !inComment;
        ++i;
    }
    return inComment;
}

class Assembler {
  public:
    Assembler(const ShaderSource& source, std::vector<std::string>& files)
        : source_(source), files_(files) {}

    std::string assemble(std::string_view name, const Defines& defines, int version) {
        // Errors in the defines have a name too.
        const std::size_t number = open("(defines)");
        text_ = "#version " + std::to_string(version) + " core\n";
        setLine(1, number);
        for (const auto& [key, value] : defines) text_ += "#define " + key + " " + value + "\n";
        const std::optional<std::string> body = source_(name);
        if (!body) throw std::runtime_error("there is no shader file " + std::string(name));
        add(name, *body);
        return std::move(text_);
    }

  private:
    std::size_t open(std::string_view name) {
        files_.emplace_back(name);
        return files_.size() - 1;
    }

    // Mesa reports source-string number 0 for most errors, whatever #line said. So the line number
    // carries the file as well. Since GLSL 3.30 it is the number of the line after the directive.
    void setLine(std::size_t line, std::size_t file) {
        text_ += "#line " + std::to_string(file * kLinesPerFile + line) + " " +
                 std::to_string(file) + "\n";
    }

    void add(std::string_view name, std::string_view body) {
        assert(std::count(body.begin(), body.end(), '\n') < std::ptrdiff_t(kLinesPerFile));
        included_.emplace_back(name);
        const std::size_t number = open(name);
        setLine(1, number);
        bool inComment = false;
        std::size_t lineNumber = 1;
        for (std::size_t begin = 0; begin < body.size(); ++lineNumber) {
            const std::size_t end = std::min(body.find('\n', begin), body.size());
            const std::string_view line = body.substr(begin, end - begin);
            begin = end + 1;
            if (inComment || !addDirective(name, lineNumber, number, line)) (text_ += line) += '\n';
            inComment = inCommentAfter(line, inComment);
        }
    }

    /// Handles the directives that are ours; false leaves the line to the driver.
    bool addDirective(std::string_view name, std::size_t lineNumber, std::size_t number,
                      std::string_view line) {
        const std::optional<std::string_view> words = directive(line);
        if (!words) return false;
        const std::string where = std::string(name) + ":" + std::to_string(lineNumber) + ": ";
        if (words->starts_with("version"))
            throw std::runtime_error(where +
                                     "#version must go; it is added when shaders are put together");
        if (words->starts_with("pragma") && trimmed(words->substr(6)) == "once") {
            text_ += '\n';
            return true;
        }
        const std::optional<std::string_view> include = quotedInclude(*words);
        if (!include) return false;
        if (std::find(included_.begin(), included_.end(), *include) != included_.end()) {
            text_ += '\n';
            return true;
        }
        const std::optional<std::string> body = source_(*include);
        if (!body)
            throw std::runtime_error(where + "there is no shader file \"" + std::string(*include) +
                                     "\"; names are relative to glsl/");
        add(*include, *body);
        setLine(lineNumber + 1, number);
        return true;
    }

    const ShaderSource& source_;
    std::vector<std::string>& files_;
    std::vector<std::string> included_;
    std::string text_;
};

}  // namespace

ShaderSource embeddedShaders() {
    return [](std::string_view name) -> std::optional<std::string> {
        for (const EmbeddedFile& file : shaders::embeddedFiles())
            if (file.name == name) return std::string(file.text);
        return std::nullopt;
    };
}

std::string assembleShader(const ShaderSource& source, std::string_view name,
                           const Defines& defines, std::vector<std::string>& files, int version) {
    return Assembler(source, files).assemble(name, defines, version);
}

std::string nameFilesInLog(std::string_view log, const std::vector<std::string>& files) {
    static const std::regex position(R"(^((?:ERROR|WARNING): )?\d+([:(])(\d+))");
    std::string result;
    for (std::size_t begin = 0; begin < log.size();) {
        const std::size_t end = std::min(log.find('\n', begin), log.size());
        const std::string line(log.substr(begin, end - begin));
        begin = end + 1;
        std::smatch match;
        // Nine digits: no number of ours is longer, and std::stoul must not overflow.
        std::size_t file = files.size(), number = 0;
        if (std::regex_search(line, match, position) && match[3].length() <= 9) {
            file = std::stoul(match[3]) / kLinesPerFile;
            number = std::stoul(match[3]) % kLinesPerFile;
        }
        if (file < files.size())
            result += match[1].str() + files[file] + match[2].str() + std::to_string(number) +
                      match.suffix().str();
        else
            result += line;
        result += '\n';
    }
    while (!result.empty() && (result.back() == '\n' || result.back() == '\0')) result.pop_back();
    return result;
}

}  // namespace sunder::gl
