#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/panels/panels.hpp"

namespace sunder::view {
namespace {

constexpr std::pair<std::string_view, const char*> kGroups[] = {
    // first field of each, in the order of materialFields()
    {"young_modulus", "Stiffness and weight"},
    {"max_stress", "Breaking"},
    {"friction", "Touching"},
    {"avg_display_section_width", "Torn edges"},
    {"colour", "Look"},
};

/// While one drags, a change is simulated if that takes no longer than this, s; else when the mouse
/// lets go.
constexpr double kLive = 0.1;

/// "young_modulus" becomes "Young modulus".
std::string label(std::string_view key) {
    std::string text(key);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!text.empty() && text[0] >= 'a') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

double sliderMin(const MaterialField& field) {
    if (!field.minExcluded) return field.min;
    return field.min == 0 ? 1e-3 : std::nextafter(field.min, field.max);
}

double sliderMax(const MaterialField& field) {
    return field.maxExcluded ? std::nextafter(field.max, field.min) : field.max;
}

bool logarithmic(const MaterialField& field) {
    return field.min >= 0 && field.max - field.min > 5 && field.unit != "degrees";
}

bool colourSliders(const MaterialField& field, Interface& ui, Vec3& value) {
    // Shown as a screen has it, kept linear.
    const auto toScreen = [](double c) {
        return static_cast<float>(c <= 0.0031308 ? 12.92 * c
                                                 : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
    };
    const auto toLinear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    float colour[3] = {toScreen(value[0]), toScreen(value[1]), toScreen(value[2])};
    const std::string name(field.key);
    ImGui::TextUnformatted(label(field.key).c_str());
    ImGui::SetNextItemWidth(-1);
    const bool changed =
        ImGui::ColorEdit3(("###" + name).c_str(), colour, ImGuiColorEditFlags_Float);
    ui.mark(name);
    ui.tooltip(field.help);
    if (changed)
        for (int i = 0; i < 3; ++i) value[i] = std::clamp(toLinear(colour[i]), 0., 1.);
    return changed;
}

bool vectorSliders(const MaterialField& field, Interface& ui, Vec3& value) {
    const std::string name(field.key);
    const double min = sliderMin(field), max = sliderMax(field);
    const std::string format = field.unit == "1" ? "%.3g" : "%.3g " + std::string(field.unit);
    ImGui::TextUnformatted((label(field.key) + ": x, y, z").c_str());
    ui.tooltip(field.help);
    ImGui::SetNextItemWidth(-1);
    const bool changed = ImGui::SliderScalarN(
        ("###" + name).c_str(), ImGuiDataType_Double, value.data(), 3, &min, &max, format.c_str(),
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic |
            ImGuiSliderFlags_NoRoundToFormat);
    ui.mark(name);
    ui.tooltip(field.help);
    return changed;
}

/// True while a field is being changed.
bool drawField(const MaterialField& field, Interface& ui, Material& material) {
    if (field.vector) {
        Vec3& value = material.*field.vector;
        return field.key.ends_with("colour") ? colourSliders(field, ui, value)
                                             : vectorSliders(field, ui, value);
    }
    ImGui::TextUnformatted(label(field.key).c_str());
    ui.tooltip(field.help);
    return ui.slider(std::string(field.key), material.*field.scalar, sliderMin(field),
                     sliderMax(field), field.unit, logarithmic(field), field.help);
}

template <class Enum>
bool drawEnum(Interface& ui, const char* name, const char* title, Enum& value, Enum last) {
    std::vector<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(last); ++i) names.push_back(toString(Enum{i}));
    ImGui::TextDisabled("%s", title);
    const int chosen = ui.choice(name, names, static_cast<int>(value));
    if (chosen >= 0) value = Enum{chosen};
    return chosen >= 0;
}

/// Says where the step limits the stiffness of this material.
void drawLimit(const Session& session, int index) {
    const World& world = session.stage->simulation.world();
    for (const ElementLaw& law : world.laws()) {
        if (law.material != index || !law.limited) continue;
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
        ImGui::TextWrapped(
            "Limited to %.3g Pa: %d substeps in 1/60 s carry no more on cells this small.",
            law.youngModulus, session.stage->simulation.stepsPerFrame());
        ImGui::PopStyleColor();
        return;
    }
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
        }
    }
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("###material", draft.material.name.c_str(),
                                        ImGuiComboFlags_HeightLargest);
    ui.mark("material");
    if (!open) return false;
    bool chosen = false;
    static const std::vector<PresetInfo> presets = materialPresets();
    for (const PresetInfo& preset : presets) {
        if (ImGui::Selectable(preset.name.c_str(), preset.name == draft.material.name)) {
            draft.material = loadMaterial(preset.name);
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
    for (const MaterialField& field : materialFields()) {
        for (const auto& [first, title] : kGroups) {
            if (field.key != first) continue;
            open = ImGui::CollapsingHeader(title, first == "young_modulus"
                                                      ? ImGuiTreeNodeFlags_DefaultOpen
                                                      : ImGuiTreeNodeFlags_None);
            ui.mark("group." + std::string(first));
            if (open && first == "young_modulus")
                done |= drawEnum(ui, "law", "Law", draft.material.law, ConstitutiveLaw::Corotated);
            if (open && first == "max_stress") {
                done |= drawEnum(ui, "fracture", "What breaks", draft.material.fracture,
                                 FractureMode::Bond);
                done |= drawEnum(ui, "clusters", "Chunks", draft.material.clusters,
                                 ClusterKind::Planks);
            }
            if (open && first == "colour")
                done |=
                    drawEnum(ui, "surface", "Surface", draft.material.surface, SurfaceKind::Glass);
        }
        if (!open) continue;
        changed |= drawField(field, ui, draft.material);
        done |= ui.letGo();
        if (field.key == "young_modulus") drawLimit(session, draft.index);
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
    }
    ui.heading("Material");
    bool apply = drawChoiceOfMaterial(session, ui, draft);
    if (!draft.material.description.empty())
        ImGui::TextWrapped("%s", draft.material.description.c_str());

    const Scene& opened = session.openedScene();
    const bool revertible = draft.index < static_cast<int>(opened.world.materials.size());
    if (ui.button("revert", "Revert", "As it was when the scene was opened.") && revertible) {
        draft.material = opened.world.materials[draft.index];
        apply = true;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-ui.length(80));
    ImGui::InputText("###material_name", &draft.fileToSave);
    ui.mark("material_name");
    ImGui::SameLine();
    if (ui.button("save_material", "Save as", "A material's file, which a scene uses by its name."))
        session.saveMaterial(draft.index, draft.fileToSave);

    ImGui::TextDisabled("Ctrl + click a slider to type a number.");
    apply |= drawFields(session, ui, draft);
    if (apply) {
        session.setMaterial(draft.index, draft.material);
        draft.generation = session.generation();
    }
}

}  // namespace sunder::view
