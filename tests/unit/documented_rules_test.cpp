// The ranges in the tables of docs/scenes.md and docs/materials.md are those of the rules.
#include <cmath>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/rules.hpp"
#include "scene/scene_rules.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A line of a table: its first two cells.
struct Row {
    std::string keys, range;
};

std::string replacedAll(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// The tables under a heading.
std::vector<Row> rowsUnder(const std::string& document, const std::string& heading) {
    std::ifstream file(std::string(SUNDER_DOCS) + "/" + document);
    REQUIRE(file);
    std::vector<Row> rows;
    bool under = heading.empty();
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("## ")) under = heading.empty() || line == "## " + heading;
        if (!under || !line.starts_with("| `")) continue;
        const std::size_t first = line.find('|', 1), second = line.find('|', first + 1);
        REQUIRE(second != std::string::npos);
        std::string range = line.substr(first + 2, second - first - 3);
        range = replacedAll(range, "−", "-");
        range = std::regex_replace(range, std::regex("([0-9]),([0-9])"), "$1$2");
        rows.push_back({line.substr(2, first - 3), range});
    }
    return rows;
}

/// 1, or 0 where the row leaves its range to another one.
int compareRow(const std::string& range, const Range& rule, int count, bool wholeFromOne) {
    INFO("documented: " << range);
    if (range == "the same" || range == "m ×3") return 0;
    if (rule.unit != "1") CHECK(range.find(rule.unit) != std::string::npos);
    if (!range.starts_with("linear RGB"))
        CHECK((range.find("×3") != std::string::npos) == (count == 3));
    CHECK((range.find("×2") != std::string::npos) == (count == 2));
    if (wholeFromOne && range.ends_with("from 1")) {
        CHECK(rule.min == 1);
        return 1;
    }
    std::smatch found;
    const std::regex pattern(
        "(above )?(-?[0-9.e-]+|twice the radius) to (less than )?(-?[0-9.e-]+)");
    REQUIRE(std::regex_search(range, found, pattern));
    CHECK(found[1].matched == rule.minExcluded);
    CHECK(found[3].matched == rule.maxExcluded);
    if (found[2] != "twice the radius") CHECK(std::stod(found[2]) == rule.min);
    CHECK(std::stod(found[4]) == rule.max);
    return 1;
}

/// How many of the rules have a range in a table. `prefix`: of keys there.
template <class Struct>
int compare(std::span<const Rule<Struct>> rules, const std::vector<Row>& rows,
            const std::string& prefix = "") {
    int compared = 0;
    for (const Rule<Struct>& rule : rules) {
        INFO(prefix << rule.key);
        bool there = false;
        for (const Row& row : rows) {
            const std::string keys =
                replacedAll(row.keys, "`…_height`",
                            "`" + row.keys.substr(1, row.keys.find("_width") - 1) + "_height`");
            if (keys.find("`" + prefix + std::string(rule.key) + "`") == std::string::npos)
                continue;
            there = true;
            compared += compareRow(row.range, rule.range, rule.count(), rule.whole());
        }
        CHECK((there || rule.key == "step"));  // a file has substeps
    }
    return compared;
}

}  // namespace

TEST_CASE("documents say the ranges that are checked", "[rules]") {
    const auto scenes = [](const std::string& heading) { return rowsUnder("scenes.md", heading); };
    CHECK(compare(worldRules(), scenes("The top level")) == 1);
    CHECK(compare(std::span(&scene::kFramesRule, 1), scenes("The top level")) == 1);
    CHECK(compare(std::span(&scene::kSubstepsRule, 1), scenes("`[solver]`")) == 1);
    CHECK(compare(std::span(&scene::kMaxSubstepsRule, 1), scenes("`[solver]`")) == 1);
    CHECK(compare(solverRules(), scenes("`[solver]`")) == 1);
    CHECK(compare(groundRules(), scenes("`[ground]`, `[room]`"), "ground.") == 1);
    CHECK(compare(roomRules(), scenes("`[ground]`, `[room]`"), "room.") == 4);
    CHECK(compare(contactRules(), scenes("`[contact]`")) == 1);
    CHECK(compare(scene::cameraRules(), scenes("`[camera]`")) == 2);
    CHECK(compare(bodyRules(), scenes("`[[body]]`")) == 3);
    CHECK(compare(scene::copiesRules(), scenes("`[[body]]`")) == 2);
    CHECK(compare(std::span(&scene::kRotationRule, 1), scenes("`[[body]]`")) == 1);
    CHECK(compare(objectRules(), scenes("`[[object]]`")) == 8);
    CHECK(compare(shapeRules(ObjectShape::Sphere), scenes("`[[object]]`")) == 1);
    CHECK(compare(shapeRules(ObjectShape::Box), scenes("`[[object]]`")) == 1);
    const Rule<ObjectDescription> length = lengthRule(1);
    CHECK(compare(std::span(&length, 1), scenes("`[[object]]`")) == 1);
    CHECK(compare(std::span(&scene::kRotationRule, 1), scenes("`[[object]]`")) == 1);
    // `time` of a push, of a blast and of a throw is checked against all three tables.
    CHECK(compare(throwRules(), scenes("`[[event]]`")) == 6);
    CHECK(compare(blastRules(), scenes("`[[event]]`")) == 1);
    const Range& vector = findRule(eventRules(EventDescription::Kind::Force), "vector")->range;
    CHECK(compareRow("N " + scenes("`[[event]]`")[5].range, vector, 3, false) == 1);
    CHECK(scenes("`[[event]]`")[5].keys == "`vector`");
    for (const Rule<EventDescription>& rule : eventRules(EventDescription::Kind::Force))
        if (rule.key != "vector") CHECK(compare(std::span(&rule, 1), scenes("`[[event]]`")) >= 1);
    CHECK(compare(materialRules(), rowsUnder("materials.md", "")) == 27);
}
