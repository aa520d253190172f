#include "states/record.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

#include "files/utf8_path.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kPassDigits = 4;
constexpr const char *kNotRun = "-", *kAsBefore = ".";

/// Passes in the order of cause and effect within a step; "objects" are their forces, "motion" is
/// where they go.
constexpr std::array kPasses = {"elements", "contacts", "objects", "stresses", "connectivity",
                                "nodes",    "bonds",    "links",   "motion"};

/// 64-bit FNV-1a over single-precision numbers, four bytes at a time.
class Hash {
  public:
    void add(float value) {
        hash_ = (hash_ ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3u;
        hash_ ^= hash_ >> 29;  // high bits would never reach low ones
    }
    void add(double value) { add(static_cast<float>(value)); }
    template <class Vector>
    void addAll(const Vector& vector) {
        for (int i = 0; i < vector.size(); ++i) add(vector[i]);
    }
    void addNodes(const State& state) {
        for (const Vec3& u : state.displacement) addAll(u);
        for (const Vec3& v : state.velocity) addAll(v);
    }
    void addBonds(const State& state) {
        for (const double damage : state.damage) add(damage);
        for (const double slow : state.slow) add(slow);
    }
    void addObjects(const State& state) {
        for (const ObjectState& object : state.objects) {
            addAll(object.position);
            addAll(object.orientation.coeffs());
            addAll(object.velocity);
            addAll(object.angularMomentum);
        }
    }
    /// As many of its hex digits.
    std::string hex(int digits) const {
        char text[17];
        std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
        return std::string(text, text + digits);
    }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

class PassHashes : public PassObserver {
  public:
    void wrote(std::string_view pass, std::span<const float> values) override {
        Hash& hash = hashes_[std::string(pass)];
        for (const float value : values) hash.add(value);
    }
    /// What it was told, and what the state shows.
    std::vector<RecordEntry::Hash> take(const State& state) {
        hashes_["nodes"].addNodes(state);
        hashes_["bonds"].addBonds(state);
        if (!state.objects.empty()) hashes_["motion"].addObjects(state);
        std::vector<RecordEntry::Hash> result;
        for (const char* pass : kPasses)
            if (hashes_.count(pass)) result.push_back({pass, hashes_[pass].hex(8)});
        hashes_.clear();
        return result;
    }

  private:
    std::map<std::string, Hash> hashes_;
};

RecordEntry recordStep(Solver& solver) {
    PassHashes passes;
    if (!solver.setPassObserver(&passes))
        throw std::logic_error(std::string(solver.name()) + " does not tell what passes write");
    solver.advance(1);
    solver.setPassObserver(nullptr);
    const State state = solver.state();
    return {state.step, passes.take(state)};
}

RecordEntry recordState(const Solver& solver) {
    const State state = solver.state();
    Hash hash;
    hash.addNodes(state);
    hash.addBonds(state);
    hash.addObjects(state);
    return {state.step, {{"state", hash.hex(16)}}};
}

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::string inFrame(std::int64_t step, int stepsPerFrame) {
    return std::to_string(step) + " (of frame " + std::to_string((step - 1) / stepsPerFrame + 1) +
           ")";
}

}  // namespace

Record parseRecord(std::istream& text, const std::string& file) {
    Record result;
    std::vector<RecordEntry::Hash> columns;  // passes, and what they wrote last
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        const auto words = wordsOf(line);
        if (words.empty() || words[0][0] == '#') continue;
        if (words[0] == "passes") {
            columns.clear();
            for (std::size_t i = 1; i < words.size(); ++i) columns.push_back({words[i], ""});
            continue;
        }
        RecordEntry entry{std::strtoll(words[0].c_str(), nullptr, 10), {}};
        bool understood = words[0].find_first_not_of("0123456789") == std::string::npos;
        if (words.size() == 3 && words[1] == "state") {
            entry.hashes.push_back({words[1], words[2]});
        } else {
            understood &= words.size() == columns.size() + 1;
            for (std::size_t i = 0; understood && i < columns.size(); ++i) {
                if (words[i + 1] == kNotRun) continue;
                if (words[i + 1] != kAsBefore) columns[i].value = words[i + 1];
                entry.hashes.push_back(columns[i]);
                understood = !columns[i].value.empty();
            }
        }
        if (!understood || entry.hashes.empty())
            throw InputError(file + ":" + std::to_string(number) +
                             ": must be a step and one hash per pass, or `state` and its hash");
        result.push_back(entry);
    }
    return result;
}

Record readRecord(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw InputError(files::utf8FromPath(path) + ": cannot be read");
    return parseRecord(file, files::utf8FromPath(path));
}

std::string toText(const Record& entries) {
    std::map<std::string, std::string> last;  // of the passes there are
    for (const RecordEntry& entry : entries)
        if (!entry.ofState())
            for (const RecordEntry::Hash& hash : entry.hashes) last[hash.what];
    std::string text, header = "passes";
    for (const char* pass : kPasses)
        if (last.count(pass)) header += std::string(" ") + pass;
    for (const RecordEntry& entry : entries) {
        if (!entry.ofState() && !header.empty()) text += std::exchange(header, {}) + "\n";
        text += std::to_string(entry.step);
        if (entry.ofState()) {
            text += " state " + entry.hashes.front().value + "\n";
            continue;
        }
        std::map<std::string, std::string> ran;
        for (const RecordEntry::Hash& hash : entry.hashes)
            ran[hash.what] = hash.value.substr(0, kPassDigits);
        for (const char* pass : kPasses) {
            if (!last.count(pass)) continue;
            const auto now = ran.find(pass);
            if (now == ran.end())
                text += std::string(" ") + kNotRun;
            else if (now->second == last[pass])
                text += std::string(" ") + kAsBefore;
            else
                text += " " + (last[pass] = now->second);
        }
        text += "\n";
    }
    return text;
}

Record everyStep(int steps) {
    Record plan = {{0, {{"state", ""}}}};
    for (int step = 1; step <= steps; ++step) plan.push_back({step, {{"passes", ""}}});
    return plan;
}

Record record(Solver& solver, const Record& plan) {
    Record result;
    std::int64_t step = solver.state().step;
    for (const RecordEntry& entry : plan) {
        const std::int64_t from = entry.ofState() ? entry.step : entry.step - 1;
        if (from > step) solver.advance(static_cast<int>(from - step));
        result.push_back(entry.ofState() ? recordState(solver) : recordStep(solver));
        step = entry.step;
    }
    return result;
}

std::string firstDifference(const Record& stored, const Record& now, int stepsPerFrame) {
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const RecordEntry &a = stored[i], &b = now[i];
        for (std::size_t k = 0; k < std::max(a.hashes.size(), b.hashes.size()); ++k) {
            const bool both = k < a.hashes.size() && k < b.hashes.size();
            if (both && a.hashes[k].what == b.hashes[k].what &&
                b.hashes[k].value.starts_with(a.hashes[k].value))
                continue;
            if (a.ofState() && i == 0) return "the state at the start differs";
            if (a.ofState())
                return "the state after step " + inFrame(a.step, stepsPerFrame) +
                       " differs; after step " + std::to_string(stored[i - 1].step) +
                       " all was the same; which pass it was is not stored for the steps between";
            const auto nameIn = [&](const RecordEntry& entry) {
                return k < entry.hashes.size() ? "the pass `" + entry.hashes[k].what + "`"
                                               : std::string("no further pass");
            };
            const std::string where =
                "step " + inFrame(a.step, stepsPerFrame) + " is the first that differs, in ";
            if (both && a.hashes[k].what == b.hashes[k].what) return where + nameIn(a);
            return where + "which passes run: " + nameIn(b) + " instead of " + nameIn(a);
        }
    }
    return {};
}
