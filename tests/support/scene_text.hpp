#pragma once
#include <functional>
#include <string>
#include <vector>

/// Scenes and materials as text, and what mistakes in them are answered with.

/// The message of the InputError that `action` throws; empty when it throws none.
std::string messageOf(const std::function<void()>& action);

/// The same of a scene, `walls.toml`.
std::string sceneError(const std::string& text);

/// The same of a material, `stuff.toml`.
std::string materialError(const std::string& text);

/// Checks that a message is one short sentence that has all these parts.
void checkParts(const std::string& message, const std::vector<std::string>& parts);

/// A text, and parts of what it is answered with.
struct Bad {
    std::string text;
    std::vector<std::string> parts;
};

/// Lines 1 to 5 of a scene; tests add line 6 and on.
inline const std::string kBody =
    "[[body]]\nname = 'wall'\nmaterial = 'wood'\nsize = [3, 2, 0.1]\ncells = [30, 20, 1]\n";

/// The text with `to` in place of the first `from`, which must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to);
