#include "support/scene_text.hpp"

#include "catch.hpp"
#include "scene/scene.hpp"

using namespace sunder;
using namespace sunder::core;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string sceneError(const std::string& text) {
    return messageOf([&] { scene::parseScene(text, "walls.toml", {}); });
}

std::string materialError(const std::string& text) {
    return messageOf([&] { scene::parseMaterial(text, "stuff.toml"); });
}

void checkParts(const std::string& message, const std::vector<std::string>& parts) {
    INFO("message: " << message);
    for (const std::string& part : parts) {
        INFO("wanted: " << part);
        CHECK(message.find(part) != std::string::npos);
    }
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() < 1500);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}
