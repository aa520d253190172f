#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/world.hpp"
#include "scene/material_file.hpp"
#include "scene/table_reader.hpp"

namespace sunder::scene {

/// Reads [[body]] tables, makes their copies and collects the materials they use.
class BodyReader {
  public:
    BodyReader(core::WorldDescription& world, MaterialLibrary& library)
        : world_(world), library_(library) {}

    void readAll(const TableReader& scene);

    /// Indices into world.bodies of the body or copy of this name, or of all copies of a body of
    /// this name. Empty: there is none.
    std::vector<int> find(const std::string& name) const;
    /// Names of the [[body]] tables, in the file's order.
    const std::vector<std::string>& names() const { return names_; }

  private:
    void readBody(const TableReader& reader);
    void readRegions(const TableReader& reader, core::BodyDescription& body);
    void addCopies(const TableReader& reader, const core::BodyDescription& body);
    void add(const TableReader& reader, core::BodyDescription body);
    int materialIndex(const TableReader& reader);

    struct Group {
        int first = 0;
        int count = 0;
    };
    core::WorldDescription& world_;
    MaterialLibrary& library_;
    std::map<std::string, int> materials_;
    std::vector<std::string> names_;
    std::map<std::string, Group> groups_;  ///< bodies, single copies and whole sets of copies
    std::int64_t cells_ = 0;
};

}  // namespace sunder::scene
