#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/material.hpp"
#include "scene/table_reader.hpp"

namespace sunder::scene {

/// Keys a material may have.
TableReader::Keys materialKeys();

/// Finds materials by name: the scene's own, presets, files.
class MaterialLibrary {
  public:
    /// Throws InputError: gets the sentence that says why a name leads to no material, adds where
    /// the name stood.
    using Complain = std::function<void(const std::string& problem)>;

    /// Relative paths start at `folder`. `depth`: how many files led here by their `base`.
    explicit MaterialLibrary(std::filesystem::path folder, int depth = 0)
        : folder_(std::move(folder)), depth_(depth) {}

    /// The scene's own materials: tables [material.NAME]. Resolves them all, so that a mistake in a
    /// material nobody uses is found too.
    void addOwn(const TableReader& scene);

    /// A scene's own material hides a preset of the same name. A material that names itself
    /// (`self`) as its base means the preset or file that it hides.
    core::Material find(const std::string& name, const Complain& complain,
                        std::string_view self = {});

  private:
    struct Own {
        TableReader reader;
        enum class State { Unread, BeingRead, Read } state = State::Unread;
        core::Material material;
    };
    const core::Material& resolve(const std::string& name, Own& own, const Complain& complain);
    std::string unknown(const std::string& name) const;

    std::filesystem::path folder_;
    int depth_;
    std::map<std::string, Own> own_;
};

}  // namespace sunder::scene
