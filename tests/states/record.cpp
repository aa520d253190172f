#include "states/record.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace sunder;

namespace {

/// Steps recorded from one in which something happens: several intervals of fracture.
constexpr int kWindow = 10;

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

/// Finds passes that do something for the first time: they write something else than they did
/// before, and than the pass before them left in the same place.
class Firsts {
  public:
    bool any(const RecordEntry& entry) {
        bool first = false;
        std::string before;
        for (const auto& [pass, value] : entry.hashes) {
            const bool acts = last_.count(pass) && value != last_[pass] && value != before;
            if (acts) first |= acted_.insert(pass).second;
            last_[pass] = before = value;
        }
        return first;
    }

  private:
    std::map<std::string, std::string> last_;
    std::set<std::string> acted_;
};

std::string inFrame(std::int64_t step, int stepsPerFrame) {
    return std::to_string(step) + " (of frame " + std::to_string((step - 1) / stepsPerFrame + 1) +
           ")";
}

}  // namespace

Record readRecord(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw InputError(path.string() + ": cannot be read");
    Record result;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        RecordEntry entry{};
        words >> entry.step;
        for (RecordEntry::Hash hash; words >> hash.what >> hash.value;)
            entry.hashes.push_back(hash);
        if (entry.hashes.empty())
            throw InputError(path.string() + ":" + std::to_string(number) +
                             ": must be a step and pairs of a pass, or `state`, and its hash");
        result.push_back(entry);
    }
    return result;
}

std::string toText(const Record& entries) {
    std::string text;
    for (const RecordEntry& entry : entries) {
        text += std::to_string(entry.step);
        for (const auto& [what, value] : entry.hashes) text += " " + what + " " + value;
        text += "\n";
    }
    return text;
}

Record planRecord(const World& world, Solver& solver, int frames, int stepsPerFrame) {
    const std::int64_t last = std::int64_t{frames} * stepsPerFrame;
    std::set<std::int64_t> begins = {1};
    for (const Event& event : world.events())
        begins.insert(static_cast<std::int64_t>(event.start) + 1);
    Firsts firsts;
    for (std::int64_t step = 1; step <= last; ++step)
        if (firsts.any(recordStep(solver))) begins.insert(step);

    std::set<std::int64_t> steps, states = {0};
    for (std::int64_t step = stepsPerFrame; step <= last; step += stepsPerFrame)
        states.insert(step);
    for (const std::int64_t begin : begins)
        for (std::int64_t step = begin; step < std::min(begin + kWindow, last + 1); ++step)
            steps.insert(step);
    for (const std::int64_t step : steps)
        if (!steps.count(step - 1)) states.insert(step - 1);  // so that a gap is known to be clean
    Record plan;
    for (std::int64_t step = 0; step <= last; ++step) {
        if (steps.count(step)) plan.push_back({step, {{"passes", ""}}});
        if (states.count(step)) plan.push_back({step, {{"state", ""}}});
    }
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
                a.hashes[k].value == b.hashes[k].value)
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
