#include "scene/body_reader.hpp"

#include <algorithm>
#include <cmath>

#include "core/names.hpp"
#include "core/orientation.hpp"
#include "core/wording.hpp"
#include "scene/limits.hpp"
#include "scene/overlap_reader.hpp"
#include "scene/scene_rules.hpp"

namespace sunder::scene {

using namespace core;

namespace {

std::string copyName(const BodyDescription& body, std::int64_t number) {
    return body.name + " " + std::to_string(number);
}

}  // namespace

void BodyReader::readAll(const TableReader& scene) {
    const TableReader::Keys keys{"name",   "material", "size",    "cells",  "position", "rotation",
                                 "anchor", "copies",   "spacing", "region", "overlap",  "present"};
    const std::vector<TableReader> readers = scene.tables("body", keys, kMaxBodies);
    if (readers.empty())
        scene.fail(
            "the scene has no body; add a table [[body]] with name, material, size and cells");
    for (const TableReader& reader : readers) readBody(reader);
}

void BodyReader::readBody(const TableReader& reader) {
    BodyDescription body;
    reader.require("name", "a name for messages and events");
    reader.read("name", body.name, kMaxName);
    reader.require("size", "[x, y, z] in m");
    reader.require("cells", "the number of cells along x, y, z, such as [30, 20, 1]");
    reader.read(bodyRules(), body);
    RotationDescription degrees;
    reader.read(kRotationRule, degrees);
    body.orientation = fromDegrees(degrees.rotation);
    body.mayOverlap = readOverlap(reader);
    reader.read("present", body.present);
    body.where = reader.where("position");
    for (const std::size_t side : reader.readChoices("anchor", kSideNames))
        body.anchors.push_back(static_cast<Side>(side));
    reader.require("material", "a material of this scene, a preset or a .toml file");
    body.material = materialIndex(reader);
    readRegions(reader, body);

    const int first = static_cast<int>(world_.bodies.size());
    const std::string name = body.name;
    addCopies(reader, body);
    const int count = static_cast<int>(world_.bodies.size()) - first;
    names_.push_back(name);
    if (count > 1 && !groups_.try_emplace(name, Group{first, count}).second)
        reader.fail("name", nameTaken("body", name));
}

void BodyReader::readRegions(const TableReader& reader, BodyDescription& body) {
    for (const TableReader& table :
         reader.tables("region", {"from", "to", "material", "empty"}, kMaxRegions)) {
        RegionDescription region;
        table.require("from", "the first cell, such as [0, 0, 0]");
        table.require("to", "the last cell, such as [3, 3, 0]");
        table.read(regionRules(), region);
        checkPlace(region, body.cells, table.complain());
        bool empty = false;
        table.read("empty", empty);
        if (empty == table.has("material"))
            table.fail(empty ? "it has both a material and empty = true; give one of them"
                             : "it has no material; give one, or empty = true to remove the cells");
        region.material = empty ? -1 : materialIndex(table);
        body.regions.push_back(region);
    }
}

void BodyReader::addCopies(const TableReader& reader, const BodyDescription& body) {
    CopiesDescription described;
    reader.read(copiesRules(), described);
    const auto& [copies, spacing] = described;
    const std::int64_t count = std::int64_t{copies[0]} * copies[1] * copies[2];
    if (count + static_cast<std::int64_t>(world_.bodies.size()) >
        static_cast<std::int64_t>(kMaxBodies))
        reader.fail("copies", "the scene has too many bodies with " + std::to_string(count) +
                                  " of these; at most " + std::to_string(kMaxBodies) +
                                  " are allowed, copies included");
    cells_ += cellsOf(body.cells, count);
    if (cells_ > kMaxCells)
        reader.fail("cells", "the scene has too many cells with this body; at most " +
                                 std::to_string(kMaxCells) +
                                 " are allowed in all, copies included; use fewer or larger cells");
    for (int axis = 0; axis < 3; ++axis) {
        if (copies[axis] == 1) continue;
        if (!reader.has("spacing"))
            reader.fail("copies",
                        "copies needs spacing, the distance from one copy to the next along "
                        "x, y, z in m");
        // Where it is turned, they may fit although this is less; World sees whether they do.
        const bool upright = isUpright(axesOf(body.orientation));
        if (upright && !body.mayOverlap && std::abs(spacing[axis]) < body.size[axis])
            reader.fail("spacing", "spacing: number " + std::to_string(axis + 1) +
                                       " must be at least the body's size, " +
                                       formatNumber(body.size[axis]) +
                                       " m, or copies overlap, not " + formatNumber(spacing[axis]));
    }
    if (count == 1) return add(reader, body);
    if (copyName(body, count).size() > kMaxName)
        reader.fail("name", "name must be at most " + std::to_string(kMaxName) +
                                " characters long with the number of each copy, as in " +
                                inQuotes(copyName(body, 1)));
    const Rule<BodyDescription>& position = *findRule(bodyRules(), "position");
    IVec3 index;
    for (index[2] = 0; index[2] < copies[2]; ++index[2])
        for (index[1] = 0; index[1] < copies[1]; ++index[1])
            for (index[0] = 0; index[0] < copies[0]; ++index[0]) {
                const int number = index[0] + copies[0] * (index[1] + copies[1] * index[2]);
                BodyDescription copy = body;
                copy.name = copyName(body, number + 1);
                copy.position += index.cast<double>().cwiseProduct(spacing);
                checkNumbers(position, copy, [&](std::string_view, const std::string& problem) {
                    reader.fail("spacing", inQuotes(copy.name) + ": " + problem);
                });
                add(reader, std::move(copy));
            }
}

void BodyReader::add(const TableReader& reader, BodyDescription body) {
    const int index = static_cast<int>(world_.bodies.size());
    if (!groups_.try_emplace(body.name, Group{index, 1}).second)
        reader.fail("name", nameTaken("body", body.name));
    world_.bodies.push_back(std::move(body));
}

int BodyReader::materialIndex(const TableReader& reader) {
    std::string name;
    reader.read("material", name, kMaxReference);
    const auto known = materials_.find(name);
    if (known != materials_.end()) return known->second;
    const auto complain = [&](const std::string& problem) { reader.fail("material", problem); };
    world_.materials.push_back(library_.find(name, complain));
    const int index = static_cast<int>(world_.materials.size()) - 1;
    materials_.emplace(name, index);
    return index;
}

std::vector<int> BodyReader::find(const std::string& name) const {
    std::vector<int> result;
    if (const auto group = groups_.find(name); group != groups_.end())
        for (int i = 0; i < group->second.count; ++i) result.push_back(group->second.first + i);
    return result;
}

}  // namespace sunder::scene
