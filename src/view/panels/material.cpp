#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "core/elasticity.hpp"
#include "core/rules.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {

using namespace core;

namespace {

using MaterialRule = Rule<Material>;

constexpr std::pair<std::string_view, const char*> kGroups[] = {
    // first field of each, in the order of materialRules()
    {"young_modulus", "Stiffness and weight"},
    {"max_stress", "Breaking"},
    {"friction", "Touching"},
    {"spread", "Chunks and scatter"},
    {"avg_display_section_width", "Torn edges"},
    {"colour", "Look"},
};

/// While one drags, a change is simulated if that takes no longer than this, s; else when the mouse
/// lets go.
constexpr double kLive = 0.1;

constexpr double kUnbounded = std::numeric_limits<double>::max();

/// "young_modulus" becomes "Young modulus".
std::string label(std::string_view key) {
    std::string text(key);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!text.empty() && text[0] >= 'a') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// A slider reaches no closer to an end that is excluded, where that is 0.
constexpr double kLeast = 1e-3;

/// A strength may be anything from next to nothing to 1e15 Pa: eighteen decades on a slider, where
/// a pixel is half as much again. So a slider reaches some way around where it was, `home`, and as
/// far as `value` has been typed.
/// More than `carried` has no effect, so it reaches below that, too.
Interface::Scale scaleOf(const MaterialRule& rule, double value, double home, double carried) {
    const Range& range = rule.range;
    const double least = range.minExcluded && range.min == 0 ? kLeast : range.least();
    const double most = range.most();
    Interface::Scale scale{least, most, false, least, most, home};
    if (most - least <= 5) return scale;
    constexpr double kReach = 20;
    if (least < 0) {
        const double reach = 5 * std::max(1.0, std::abs(home));
        scale.min = std::max(least, home - reach);
        scale.max = std::min(most, home + reach);
    } else {
        scale.logarithmic = true;
        scale.min = least == 0 ? 0 : std::max(least, home / kReach);
        scale.max = std::min(most, home > 0 ? home * kReach : 1);
    }
    scale.min = std::max(least, std::min(scale.min, carried / kReach));
    scale.min = std::min(scale.min, value);
    scale.max = std::max(scale.max, value);
    return scale;
}

struct Unit {
    double size;
    std::string name;
};
/// Stresses are read in thousands, millions or thousands of millions of pascals.
Unit unitOf(const MaterialRule& rule, double home) {
    constexpr std::pair<double, const char*> kPascals[] = {
        {1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}};
    if (rule.range.unit == "Pa")
        for (const auto& [size, name] : kPascals)
            if (home >= size) return {size, name};
    return {1, std::string(rule.range.unit)};
}

/// One number of a field. True while it is being changed.
bool drawNumber(const MaterialRule& rule, Interface& ui, const std::string& name, double& value,
                double home, double carried, const std::string& help) {
    Interface::Scale scale = scaleOf(rule, value, home, carried);
    const Unit unit = unitOf(rule, home);
    scale.unit = unit.size;
    return ui.slider(name, value, scale, unit.name, help);
}

/// Why a field has no effect on this material; empty: it has one.
std::string_view idleBecause(const Material& material, std::string_view key) {
    const auto among = [&](std::initializer_list<std::string_view> keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    if (among({"max_stress"}) && material.fracture != FractureMode::Cell)
        return "Without effect here: it is for what breaks by 'cell'.";
    if (among({"strength", "boundary_strength", "damage_length", "shear_weight",
               "internal_friction", "spread", "noise_length", "noise_amplitude"}) &&
        material.fracture != FractureMode::Bond)
        return "Without effect here: it is for what breaks by 'bond'.";
    if (among({"boundary_strength", "cluster_size", "joint_width"}) &&
        material.clusters == ClusterKind::None)
        return "Without effect here: there are no chunks.";
    if (among({"noise_amplitude"}) && material.noiseLength == 0)
        return "Without effect here: the noise length is 0.";
    return {};
}

bool colourSliders(const MaterialRule& rule, Interface& ui, Vec3& value) {
    // Shown as a screen has it, kept linear.
    const auto toScreen = [](double c) {
        return static_cast<float>(c <= 0.0031308 ? 12.92 * c
                                                 : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
    };
    const auto toLinear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    float colour[3] = {toScreen(value[0]), toScreen(value[1]), toScreen(value[2])};
    const std::string name(rule.key);
    ImGui::TextUnformatted(label(rule.key).c_str());
    ImGui::SetNextItemWidth(-1);
    const bool changed =
        ImGui::ColorEdit3(("###" + name).c_str(), colour, ImGuiColorEditFlags_Float);
    ui.mark(name);
    ui.tooltip(rule.help);
    if (changed)
        for (int i = 0; i < 3; ++i) value[i] = std::clamp(toLinear(colour[i]), 0., 1.);
    return changed;
}

bool vectorSliders(const MaterialRule& rule, Interface& ui, Vec3& value, const Vec3& home,
                   bool& letGo, const std::string& help) {
    constexpr const char* kAxes[] = {"x", "y", "z"};
    ImGui::TextUnformatted(label(rule.key).c_str());
    ui.tooltip(help);
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", kAxes[axis]);
        ImGui::SameLine(ui.length(18));
        changed |= drawNumber(rule, ui, std::string(rule.key) + "." + kAxes[axis], value[axis],
                              home[axis], kUnbounded, help);
        letGo |= ui.letGo();
    }
    return changed;
}

/// True while a field is being changed.
bool drawField(const MaterialRule& rule, Interface& ui, MaterialDraft& draft, double carried,
               bool& letGo) {
    Material& material = draft.material;
    const std::string_view idle = idleBecause(material, rule.key);
    std::string help(rule.help);
    if (!idle.empty()) help += "\n" + std::string(idle);
    ImGui::BeginDisabled(!idle.empty());
    bool changed = false;
    if (const auto* vector = std::get_if<Vec3 Material::*>(&rule.field)) {
        Vec3& value = material.**vector;
        if (rule.key.ends_with("colour")) {
            changed = colourSliders(rule, ui, value);
            letGo |= ui.letGo();
        } else {
            changed = vectorSliders(rule, ui, value, draft.home.**vector, letGo, help);
        }
    } else if (const auto* scalar = std::get_if<double Material::*>(&rule.field)) {
        ImGui::TextUnformatted(label(rule.key).c_str());
        ui.tooltip(help);
        changed = drawNumber(rule, ui, std::string(rule.key), material.**scalar,
                             draft.home.**scalar, carried, help);
        letGo |= ui.letGo();
    }
    ImGui::EndDisabled();
    return changed;
}

template <class Enum, std::size_t Count>
bool drawEnum(Interface& ui, const char* name, const char* title, Enum& value,
              const std::string_view (&help)[Count]) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < Count; ++i) names.push_back(toString(static_cast<Enum>(i)));
    ImGui::TextDisabled("%s", title);
    const int chosen = ui.choice(name, names, static_cast<int>(value), help);
    if (chosen >= 0) value = static_cast<Enum>(chosen);
    return chosen >= 0;
}

/// The choices above a group's sliders. True when one was made.
bool drawChoices(std::string_view group, Interface& ui, Material& material) {
    if (group == "young_modulus")
        return drawEnum(ui, "law", "Law", material.law,
                        {"Green's strain, as the thesis has it. Gives way when squeezed hard.",
                         "Linear elasticity that turns with each cell. Survives being crushed."});
    if (group == "max_stress")
        return drawEnum(ui, "fracture", "What breaks", material.fracture,
                        {"Nothing: it only bends.",
                         "Cells, as the thesis has it: one leaves all its neighbours at once.",
                         "Faces between cells, one by one: cracks run, and chunks come apart."});
    if (group == "spread")
        return drawEnum(ui, "clusters", "Chunks", material.clusters,
                        {"None: it breaks anywhere.", "Irregular, as in concrete or glass.",
                         "Bricks in rows, every other one shifted by half a brick.",
                         "Strips side by side, upright."});
    if (group == "colour")
        return drawEnum(
            ui, "surface", "Surface", material.surface,
            {"One colour.", "Grain upwards, rings across.",
             "Bricks and mortar, where chunks are bricks.", "Cement, with stones inside.",
             "Matt and even.", "Smooth; transparency says how clear."});
    return false;
}

/// Pa, the most that the step carries on the cells of this material.
double carriedStiffness(const Session& session, int index) {
    const World& world = session.stage->simulation.world();
    const Material& material = world.description().materials[index];
    double least = kUnbounded;
    for (const ElementLaw& law : world.laws())
        if (law.material == index)
            least = std::min(least, stableYoungModulus(material.density, law.cellSize.minCoeff(),
                                                       material.poissonRatio, world.step()));
    return least;
}

/// Says where the step limits the stiffness of this material.
void drawLimit(const Session& session, int index) {
    for (const ElementLaw& law : session.stage->simulation.world().laws()) {
        if (law.material != index || !law.limited) continue;
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
        ImGui::TextWrapped(
            "Limited to %s: %d substeps in 1/60 s carry no more on cells this small.",
            brief(law.youngModulus, "Pa").c_str(), session.stage->simulation.stepsPerFrame());
        ImGui::PopStyleColor();
        return;
    }
}

/// Where Revert and right clicks take a material of the scene: as it was when the scene was opened,
/// or as it is where another one is in its place.
Material homeOf(const Session& session, const Material& now, int index) {
    const auto& opened = session.openedScene().world.materials;
    const bool there = index < static_cast<int>(opened.size()) && opened[index].name == now.name;
    return there ? opened[index] : now;
}

/// True when another one was chosen.
bool drawChoiceOfMaterial(Session& session, Interface& ui, MaterialDraft& draft) {
    const auto& materials = session.scene().world.materials;
    if (materials.size() > 1) {
        ImGui::TextDisabled("Material of the scene");
        std::vector<std::string_view> names;
        for (const Material& material : materials) names.push_back(material.name);
        if (const int chosen = ui.choice("which", names, draft.index); chosen >= 0) {
            draft.index = chosen;
            draft.material = materials[chosen];
            draft.home = homeOf(session, draft.material, chosen);
        }
    }
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("###material", draft.material.name.c_str(),
                                        ImGuiComboFlags_HeightLargest);
    ui.mark("material");
    if (!open) return false;
    bool chosen = false;
    static const std::vector<scene::PresetInfo> presets = scene::materialPresets();
    for (const scene::PresetInfo& preset : presets) {
        if (ImGui::Selectable(preset.name.c_str(), preset.name == draft.material.name)) {
            draft.material = draft.home = scene::loadMaterial(preset.name);
            chosen = true;
        }
        ui.mark("material." + preset.name);
        ui.tooltip(preset.title);
    }
    ImGui::EndCombo();
    return chosen;
}

bool drawFields(Session& session, Interface& ui, MaterialDraft& draft) {
    bool changed = false, open = false, done = false;
    for (const MaterialRule& rule : materialRules()) {
        for (const auto& [first, title] : kGroups) {
            if (rule.key != first) continue;
            open = ImGui::CollapsingHeader(title, first == "young_modulus"
                                                      ? ImGuiTreeNodeFlags_DefaultOpen
                                                      : ImGuiTreeNodeFlags_None);
            ui.mark("group." + std::string(first));
            if (open) done |= drawChoices(first, ui, draft.material);
        }
        if (!open) continue;
        const double carried =
            rule.key == "young_modulus" ? carriedStiffness(session, draft.index) : kUnbounded;
        changed |= drawField(rule, ui, draft, carried, done);
        if (rule.key == "young_modulus") drawLimit(session, draft.index);
    }
    draft.age += ImGui::GetIO().DeltaTime;
    const bool live = changed && session.buildTime() < kLive && draft.age > 2 * session.buildTime();
    if (live || done) draft.age = 0;
    return live || done;
}

}  // namespace

void drawMaterial(Session& session, Interface& ui, MaterialDraft& draft) {
    if (draft.generation != session.generation() && !ImGui::IsAnyItemActive()) {
        const int count = static_cast<int>(session.scene().world.materials.size());
        draft.index = std::min(draft.index, count - 1);
        draft.material = session.scene().world.materials[draft.index];
        draft.generation = session.generation();
        if (std::exchange(draft.layout, session.layout()) != session.layout())
            draft.home = homeOf(session, draft.material, draft.index);
    }
    ui.heading("Material");
    bool apply = drawChoiceOfMaterial(session, ui, draft);
    if (!draft.material.description.empty())
        ImGui::TextWrapped("%s", draft.material.description.c_str());

    if (ui.button("revert", "Revert",
                  "Every number as it was when the scene was opened or this material chosen. A "
                  "right click on a slider does it for one.")) {
        draft.material = draft.home;
        apply = true;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-ui.length(80));
    bool save = ImGui::InputText("###material_name", &draft.fileToSave,
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    ui.mark("material_name");
    ImGui::SameLine();
    save |=
        ui.button("save_material", "Save as", "A material's file, which a scene uses by its name.");
    if (save) session.saveMaterial(draft.index, draft.fileToSave);

    ImGui::TextDisabled("Ctrl + click: type. Right click: take back.");
    apply |= drawFields(session, ui, draft);
    if (apply) {
        session.setMaterial(draft.index, draft.material);
        draft.generation = session.generation();
    }
}

}  // namespace sunder::view
