#pragma once
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// XML without what our files have no need of: comments, CDATA, entities in attributes.
class XmlReader {
  public:
    using Attributes = std::map<std::string, std::string>;

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
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
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
