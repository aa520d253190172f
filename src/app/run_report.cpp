#include "app/run_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/pieces.hpp"

namespace sunder::app {

using namespace core;

namespace {

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

std::string hex(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

/// JSON has no NaN: such numbers become null.
nlohmann::json number(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json numbers(std::initializer_list<double> values) {
    nlohmann::json list = nlohmann::json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}
nlohmann::json numbers(const Vec3& v) {
    return numbers({v[0], v[1], v[2]});
}

std::string threeDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

nlohmann::ordered_json incidentsJson(const World& world, const State& state,
                                     const IncidentTally& tally) {
    using nlohmann::ordered_json;
    const Pieces pieces = findPieces(world, state);
    ordered_json strongest = ordered_json::array();
    for (const Incident& incident : tally.strongest) {
        const Vec3& x = incident.place;
        strongest.push_back(
            {{"kind", incident.kind == Incident::Kind::Break ? "break" : "contact"},
             {"time", static_cast<double>(incident.step) * world.step()},
             {"place", numbers(x)},
             {"impulse", number(incident.impulse)},
             {"materials", materialsOf(world, incident)},
             {"piece", pieces.ofCell[incident.cell]},
             {"object", incident.object < 0
                            ? ordered_json()
                            : ordered_json(world.description().objects[incident.object].name)}});
    }
    return {{"contacts", tally.contacts},
            {"breaks", tally.breaks},
            {"dropped", tally.dropped},
            {"capacity", tally.capacity},
            {"strongest", strongest}};
}

/// One that has not been thrown yet is nowhere: null.
nlohmann::ordered_json objectsJson(const World& world, const State& state) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const ObjectDescription& description = world.description().objects[i];
        const ObjectState& object = state.objects[i];
        const Eigen::Quaterniond& q = object.orientation;
        const auto ifPresent = [&](const nlohmann::json& value) {
            return object.present ? value : nlohmann::json();
        };
        list.push_back({{"name", description.name},
                        {"present", object.present},
                        {"position", ifPresent(numbers(object.position))},
                        {"orientation", ifPresent(numbers({q.x(), q.y(), q.z(), q.w()}))},
                        {"velocity", ifPresent(numbers(object.velocity))},
                        {"spin", ifPresent(numbers(object.spin(world.objects()[i])))},
                        {"fixed", description.fixed}});
    }
    return list;
}

/// Bodies whose contacts may have been missed.
nlohmann::ordered_json outrunJson(const World& world, const std::vector<double>& haste) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t body = 0; body < haste.size(); ++body)
        if (haste[body] > 1)
            list.push_back(
                {{"body", world.bodies()[body].name}, {"times_too_fast", number(haste[body])}});
    return list;
}

nlohmann::ordered_json sunkJson(const std::vector<Sunk>& sunk) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Sunk& pair : sunk)
        list.push_back({{"a", pair.a}, {"b", pair.b}, {"depth", number(pair.depth)}});
    return list;
}

}  // namespace

std::string reportJson(const scene::Scene& scene, const World& world, const State& state,
                       const RunFacts& facts) {
    using nlohmann::ordered_json;
    const Diagnostics d = diagnose(world, state);
    ordered_json limits = ordered_json::array();
    for (const ElementLaw& law : world.laws())
        if (law.limited) {
            const Material& material = world.description().materials[law.material];
            limits.push_back({{"material", material.name},
                              {"young_modulus", material.youngModulus},
                              {"limited_to", law.youngModulus},
                              {"sags_times_as_far", material.youngModulus / law.youngModulus}});
        }
    ordered_json report = {
        {"scene", scene.name},
        {"solver", facts.solver},
        {"gl_renderer", facts.renderer},
        {"frames", facts.frames},
        {"dt", world.step()},
        {"steps_per_frame", facts.stepsPerFrame},
        {"seed", world.description().seed},
        {"cells", world.presentCells()},
        {"tetrahedra", kTetrahedraPerCell * world.presentCells()},
        {"nodes", kCorners * world.presentCells()},
        {"bonds_total", world.bondCount()},
        {"bonds_broken", d.bondsBroken},
        {"pieces", d.pieces},
        {"state_hash", hex(stateHash(state))},
        {"incidents", incidentsJson(world, state, facts.incidents)},
        {"energy",
         {{"kinetic", number(d.kinetic)},
          {"elastic", number(d.elastic)},
          {"gravity", number(d.gravity)}}},
        {"momentum", numbers(d.momentum)},
        {"min_y", number(d.minY)},
        {"max_speed", number(d.maxSpeed)},
        {"nan", d.nan},
        {"objects", objectsJson(world, state)},
        {"lost",
         {{"contacts", facts.losses.contacts},
          {"outrun", outrunJson(world, facts.losses.haste)},
          {"sunk", sunkJson(facts.losses.sunk)}}},
        {"ms_per_step",
         {{"median", percentile(facts.msPerStep, 0.5)},
          {"p95", percentile(facts.msPerStep, 0.95)}}},
        {"stiffness_limited", limits},
    };
    if (facts.bodiesOnGpu) report["bodies_on_gpu"] = *facts.bodiesOnGpu;
    return report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string reportText(const scene::Scene& scene, const World& world, const State& state,
                       const RunFacts& facts) {
    const Diagnostics d = diagnose(world, state);
    std::ostringstream text;
    text << scene.name << ": " << facts.frames << " frames of " << facts.stepsPerFrame << " steps, "
         << kTetrahedraPerCell * world.presentCells() << " tetrahedra, solver " << facts.solver;
    if (!facts.renderer.empty()) text << " on " << facts.renderer;
    if (facts.bodiesOnGpu)
        text << ", " << *facts.bodiesOnGpu << " of " << world.bodies().size()
             << " bodies on the GPU at the end";
    text << "\nbonds broken " << d.bondsBroken << " of " << world.bondCount() << ", pieces "
         << d.pieces << ", fastest node " << threeDigits(d.maxSpeed) << " m/s, "
         << threeDigits(percentile(facts.msPerStep, 0.5)) << " ms per step\n";
    const IncidentTally& tally = facts.incidents;
    text << "incidents: " << tally.breaks << " breaks, " << tally.contacts << " contacts";
    if (!tally.strongest.empty())
        text << ", up to " << threeDigits(tally.strongest.front().impulse) << " N·s";
    if (tally.dropped > 0)
        text << "; " << tally.dropped << " more than there was room for (" << tally.capacity
             << " at a time)";
    text << "\n";
    if (d.nan) text << d.nan << " nodes are not a number: this is a defect, please report it\n";
    return text.str();
}

}  // namespace sunder::app
