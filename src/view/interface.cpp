#include "view/interface.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>

namespace sunder::view {
namespace {

constexpr float kLetters = 15;  // pixels at scale 1

/// A font that a system of this kind has; null: ImGui's own, which has one size.
const char* systemFont() {
    constexpr const char* kKnown[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/System/Library/Fonts/Supplemental/Arial.ttf", "C:/Windows/Fonts/segoeui.ttf"};
    std::error_code error;
    for (const char* path : kKnown)
        if (std::filesystem::is_regular_file(path, error)) return path;
    return nullptr;
}

void loadFont(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    // Latin-1, dashes and quotes.
    static const ImWchar ranges[] = {0x20, 0xff, 0x2010, 0x2027, 0};
    const float pixels = std::round(kLetters * scale);
    if (const char* path = systemFont()) {
        atlas.AddFontFromFileTTF(path, pixels, nullptr, ranges);
        return;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    atlas.AddFontDefault(&config);
}

ImVec4 mix(const ImVec4& a, float alpha) {
    return {a.x, a.y, a.z, alpha};
}

void setStyle(float scale) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 0;
    style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
    style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.WindowTitleAlign = {0.5f, 0.5f};

    const ImVec4 accent(0.93f, 0.56f, 0.20f, 1), ground(0.105f, 0.11f, 0.125f, 1);
    const ImVec4 field(0.19f, 0.20f, 0.23f, 1), raised(0.25f, 0.265f, 0.30f, 1);
    ImVec4* const colours = style.Colors;
    colours[ImGuiCol_Text] = {0.92f, 0.92f, 0.90f, 1};
    colours[ImGuiCol_TextDisabled] = {0.60f, 0.61f, 0.63f, 1};
    colours[ImGuiCol_WindowBg] = ground;
    colours[ImGuiCol_PopupBg] = {0.13f, 0.135f, 0.155f, 0.98f};
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = field;
    colours[ImGuiCol_FrameBg] = field;
    colours[ImGuiCol_FrameBgHovered] = raised;
    colours[ImGuiCol_FrameBgActive] = raised;
    colours[ImGuiCol_Button] = field;
    colours[ImGuiCol_ButtonHovered] = raised;
    colours[ImGuiCol_ButtonActive] = mix(accent, 0.8f);
    colours[ImGuiCol_Header] = field;
    colours[ImGuiCol_HeaderHovered] = raised;
    colours[ImGuiCol_HeaderActive] = raised;
    // The number shows through.
    colours[ImGuiCol_SliderGrab] = mix(accent, 0.55f);
    colours[ImGuiCol_SliderGrabActive] = mix(accent, 0.8f);
    colours[ImGuiCol_CheckMark] = accent;
    colours[ImGuiCol_Tab] = ground;
    colours[ImGuiCol_TabHovered] = raised;
    colours[ImGuiCol_TabActive] = raised;
    colours[ImGuiCol_PlotLines] = accent;
    colours[ImGuiCol_PlotHistogram] = accent;
    colours[ImGuiCol_TextSelectedBg] = mix(accent, 0.35f);
    colours[ImGuiCol_Separator] = raised;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace

Interface::Interface(window::Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // Settings remember what is worth it
    io.ConfigWindowsMoveFromTitleBarOnly = true;
#if IMGUI_VERSION_NUM >= 18700
    io.ConfigInputTrickleEventQueue = false;  // feed() and its callers know better what waits
#endif
    // Without callbacks of its own: they would hand on at once what comes, whatever else the frame
    // has in store.
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
    mouse_.inside = window.input().inside;
    mouse_.x = window.input().x;
    mouse_.y = window.input().y;
    ImGui_ImplOpenGL3_Init("#version 410 core");
}

Interface::~Interface() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Interface::setScale(float scale) {
    if (scale == scale_) return;
    scale_ = scale;
    loadFont(scale);
    setStyle(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Interface::feed(const window::InputEvent& event) {
    using Kind = window::InputEvent::Kind;
    GLFWwindow* const window = window_.handle();
    const auto& glfw = event.glfw;
    fed_ = true;
    mouse_.x = event.x;
    mouse_.y = event.y;
    switch (event.kind) {
        case Kind::Move:
            break;
        case Kind::Enter:
        case Kind::Leave:
            mouse_.inside = event.kind == Kind::Enter;
            ImGui_ImplGlfw_CursorEnterCallback(window, mouse_.inside);
            break;
        case Kind::Press:
        case Kind::Release:
            mouse_.held[static_cast<int>(event.button)] = event.kind == Kind::Press;
            break;
        case Kind::Wheel:
            mouse_.wheelX += event.wheelX;
            mouse_.wheelY += event.wheelY;
            break;
        case Kind::KeyDown:
        case Kind::KeyUp:
            ImGui_ImplGlfw_KeyCallback(window, glfw.key, glfw.scancode,
                                       event.kind == Kind::KeyDown ? GLFW_PRESS : GLFW_RELEASE,
                                       glfw.modifiers);
            break;
        case Kind::Character:
            ImGui_ImplGlfw_CharCallback(window, event.character);
            break;
        case Kind::Focus:
        case Kind::Blur:
            ImGui_ImplGlfw_WindowFocusCallback(window, event.kind == Kind::Focus);
            break;
    }
    modifiers_ = glfw.modifiers;
}

/// Where the mouse was when that happened which was fed last. ImGui's backend for GLFW asks GLFW,
/// which only knows how things are at the frame's end: before 1.87 of the mouse, and from then on
/// of the keys that go with it.
void Interface::pointMouse() const {
    ImGuiIO& io = ImGui::GetIO();
    const bool held = std::any_of(std::begin(mouse_.held), std::end(mouse_.held), std::identity());
    constexpr float kNowhere = -std::numeric_limits<float>::max();
    const float d = density();
    const ImVec2 place = mouse_.inside || held ? ImVec2(static_cast<float>(mouse_.x) / d,
                                                        static_cast<float>(mouse_.y) / d)
                                               : ImVec2(kNowhere, kNowhere);
    const auto wheelX = static_cast<float>(mouse_.wheelX);
    const auto wheelY = static_cast<float>(mouse_.wheelY);
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(place.x, place.y);
    for (int i = 0; i < window::kMouseButtons; ++i) io.AddMouseButtonEvent(i, mouse_.held[i]);
    if (wheelX != 0 || wheelY != 0) io.AddMouseWheelEvent(wheelX, wheelY);
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, (modifiers_ & GLFW_MOD_CONTROL) != 0);
    io.AddKeyEvent(ImGuiMod_Shift, (modifiers_ & GLFW_MOD_SHIFT) != 0);
    io.AddKeyEvent(ImGuiMod_Alt, (modifiers_ & GLFW_MOD_ALT) != 0);
    io.AddKeyEvent(ImGuiMod_Super, (modifiers_ & GLFW_MOD_SUPER) != 0);
#endif
#else
    io.MousePos = place;
    std::copy(std::begin(mouse_.held), std::end(mouse_.held), io.MouseDown);
    io.MouseWheelH += wheelX;
    io.MouseWheel += wheelY;
#endif
}

void Interface::begin(double scale) {
    // Where the desktop's coordinates are larger than pixels, it scales the interface itself.
    const float own = window_.contentScale() / std::max(1.f, density());
    setScale(std::clamp(own * static_cast<float>(scale), 0.5f, 8.f));
    widgets_.clear();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    pointMouse();
    mouse_.wheelX = mouse_.wheelY = 0;
    fed_ = false;
    ImGui::NewFrame();
}

void Interface::end() {
    ImGui::EndFrame();
}

void Interface::clear() const {
    const ImVec4& ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    window_.clear(ground.x, ground.y, ground.z);
}

void Interface::draw() {
    ImGui::Render();
    window_.bind();  // the interface's colours are sRGB already
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

float Interface::density() const {
    const float density = ImGui::GetIO().DisplayFramebufferScale.x;
    return density > 0 ? density : 1;
}

bool Interface::wantsMouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Interface::wantsKeyboard() const {
    return ImGui::GetIO().WantTextInput;
}

void Interface::mark(const std::string& name) {
    // A tooltip is a window, after which ImGui knows nothing of the widget any more.
    letGo_ = ImGui::IsItemDeactivatedAfterEdit();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (!ImGui::IsItemVisible()) return;
    const float d = density();
    widgets_[name] = {low.x * d, low.y * d, high.x * d, high.y * d};
}

bool Interface::hovered() {
    // While somebody drags a tooltip would hide the value.
    return !ImGui::IsAnyItemActive() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
}

void Interface::tooltip(std::string_view text) const {
    if (text.empty() || !hovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool Interface::button(const std::string& name, const std::string& label, const std::string& help) {
    const bool clicked = ImGui::Button((label + "###" + name).c_str());
    mark(name);
    tooltip(help);
    return clicked;
}

bool Interface::checkbox(const std::string& name, const std::string& label, bool& value,
                         const std::string& help) {
    const bool clicked = ImGui::Checkbox((label + "###" + name).c_str(), &value);
    mark(name);
    tooltip(help);
    return clicked;
}

int Interface::choice(const std::string& name, std::span<const std::string_view> labels, int chosen,
                      std::span<const std::string_view> help) {
    int clicked = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {length(5), length(4)});
    const ImGuiStyle& style = ImGui::GetStyle();
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
        const std::string text(labels[i]);
        const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * style.FramePadding.x;
        const float gap = length(3);
        if (i > 0 && ImGui::GetItemRectMax().x + gap + width <= end) ImGui::SameLine(0, gap);
        if (i == chosen) {
            const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
            ImGui::PushStyleColor(ImGuiCol_Button, accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, accent);
            ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.08f, 0.07f, 0.05f, 1));
        }
        const std::string id = name + "." + text;
        ImGui::PushID(i);  // labels may be alike
        if (ImGui::Button((text + "###" + id).c_str())) clicked = i;
        ImGui::PopID();
        if (i == chosen) ImGui::PopStyleColor(3);
        mark(id);
        if (i < static_cast<int>(help.size())) tooltip(help[i]);
    }
    ImGui::PopStyleVar();
    return clicked;
}

void Interface::label(const char* text, std::string_view help) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    tooltip(help);
    ImGui::SameLine(length(70));
}

bool Interface::slider(const std::string& name, double& value, const Scale& scale,
                       std::string_view unit, std::string_view help) {
    const std::string suffix = unit == "1" ? std::string() : " " + std::string(unit);
    ImGui::SetNextItemWidth(-1);
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_NoRoundToFormat |
        (scale.logarithmic ? static_cast<int>(ImGuiSliderFlags_Logarithmic) : 0);
    double shown = value / scale.unit;
    const double min = scale.min / scale.unit, max = scale.max / scale.unit;
    bool changed = ImGui::SliderScalar(("###" + name).c_str(), ImGuiDataType_Double, &shown, &min,
                                       &max, ("%.4g" + suffix).c_str(), flags);
    if (changed) value = std::clamp(shown * scale.unit, scale.least, scale.most);
    mark(name);
    if (scale.home && value != *scale.home && ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        value = *scale.home;
        changed = letGo_ = true;
    }
    if (!hovered()) return changed;
    char range[160];
    std::snprintf(range, sizeof range, "\n%.4g to %.4g%s. Ctrl + click: type a number.",
                  scale.least / scale.unit, scale.most / scale.unit, suffix.c_str());
    std::string text = std::string(help) + range;
    if (scale.home) {
        std::snprintf(range, sizeof range, " Right click: %.4g, as it was.",
                      *scale.home / scale.unit);
        text += range;
    }
    tooltip(text);
    return changed;
}

void Interface::heading(const char* text) {
    ImGui::Dummy({0, length(4)});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

}  // namespace sunder::view
