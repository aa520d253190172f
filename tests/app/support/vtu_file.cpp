#include "app/support/vtu_file.hpp"

#include <sstream>
#include <stdexcept>

namespace {

using Attributes = std::map<std::string, std::string>;

/// XML without what a .vtu has no need of: comments, CDATA, entities.
class XmlReader {
  public:
    explicit XmlReader(const std::string& text) : text_(text) {}

    /// Calls visitor.open(name, attributes, stack) and visitor.text(characters) in order.
    template <class Visitor>
    void read(Visitor& visitor) {
        if (accept("<?xml")) at_ = find("?>") + 2;
        bool rootSeen = false;
        while (at_ < text_.size()) {
            const std::size_t tag = std::min(text_.find('<', at_), text_.size());
            const std::string characters = text_.substr(at_, tag - at_);
            at_ = tag;
            const bool blank = characters.find_first_not_of(" \t\r\n") == std::string::npos;
            if (stack_.empty() && !blank) fail("text outside of the root");
            if (!blank) visitor.text(characters);
            if (at_ == text_.size()) break;
            if (accept("</")) {
                const std::string name = readName();
                if (stack_.empty() || stack_.back() != name) fail("</" + name + "> closes nothing");
                stack_.pop_back();
                require(">");
            } else {
                if (stack_.empty() && rootSeen) fail("a second root");
                rootSeen = true;
                readOpening(visitor);
            }
        }
        if (!stack_.empty()) fail("<" + stack_.back() + "> is not closed");
        if (!rootSeen) fail("no element");
    }

  private:
    template <class Visitor>
    void readOpening(Visitor& visitor) {
        require("<");
        const std::string name = readName();
        Attributes attributes;
        for (skipBlanks(); text_.compare(at_, 1, ">") != 0 && text_.compare(at_, 2, "/>") != 0;
             skipBlanks()) {
            const std::string key = readName();
            require("=\"");
            const std::size_t end = find("\"");
            const std::string value = text_.substr(at_, end - at_);
            if (value.find_first_of("<&") != std::string::npos) fail("a bare < or & in " + key);
            if (!attributes.emplace(key, value).second) fail(key + " twice in <" + name + ">");
            at_ = end + 1;
            if (text_.find_first_of(" \t\r\n/>", at_) != at_) fail("no space after " + key);
        }
        visitor.open(name, attributes, stack_);
        if (accept("/>")) return;
        require(">");
        stack_.push_back(name);
    }
    std::string readName() {
        static const std::string kLetters =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
        const std::size_t end = std::min(text_.find_first_not_of(kLetters, at_), text_.size());
        if (end == at_) fail("a name is missing");
        const std::string name = text_.substr(at_, end - at_);
        at_ = end;
        return name;
    }
    void skipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
    bool accept(const std::string& part) {
        if (text_.compare(at_, part.size(), part) != 0) return false;
        at_ += part.size();
        return true;
    }
    void require(const std::string& part) {
        if (!accept(part)) fail(part + " is missing");
    }
    std::size_t find(const std::string& part) const {
        const std::size_t found = text_.find(part, at_);
        if (found == std::string::npos) fail(part + " is missing");
        return found;
    }
    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error("at byte " + std::to_string(at_) + ": " + problem);
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::vector<std::string> stack_;
};

std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::size_t used = 0;
        numbers.push_back(std::stod(word, &used));
        if (used != word.size()) throw std::runtime_error("'" + word + "' is not a number");
    }
    return numbers;
}

struct VtuBuilder {
    VtuFile file;
    VtuArray* current = nullptr;

    void open(const std::string& name, const Attributes& attributes,
              const std::vector<std::string>& parents) {
        current = nullptr;
        if (name == "VTKFile" && attributes.at("type") != "UnstructuredGrid")
            throw std::runtime_error("not an unstructured grid");
        if (name == "Piece") {
            file.points = std::stoi(attributes.at("NumberOfPoints"));
            file.cells = std::stoi(attributes.at("NumberOfCells"));
        }
        if (name != "DataArray") return;
        const std::vector<std::string> wanted{"VTKFile", "UnstructuredGrid", "Piece"};
        if (parents.size() != 4 || !std::equal(wanted.begin(), wanted.end(), parents.begin()))
            throw std::runtime_error("a DataArray at the wrong place");
        if (attributes.at("format") != "ascii") throw std::runtime_error("an array is not text");
        const auto [entry, isNew] = file.arrays.try_emplace(attributes.at("Name"));
        if (!isNew) throw std::runtime_error(entry->first + " twice");
        current = &entry->second;
        current->section = parents.back();
        current->type = attributes.at("type");
        if (attributes.count("NumberOfComponents"))
            current->components = std::stoi(attributes.at("NumberOfComponents"));
    }
    void text(const std::string& characters) {
        if (!current) throw std::runtime_error("text outside of a DataArray");
        current->values = numbersIn(characters);
    }
};

}  // namespace

VtuFile parseVtu(const std::string& text) {
    VtuBuilder builder;
    XmlReader(text).read(builder);
    return builder.file;
}
