// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gui.h"

#include "ui/keys.h"

#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

// Returns how long the mouse has been over its present item; ImGui's own count begins anew in every
// frame where one item lies over another.
double hovered_for_s(ImGuiContext& g)
{
    const ImGuiID thing = ImHashStr("hovered"), since = ImHashStr("hovered since");
    ImGuiStorage& memory = g.Windows[0]->StateStorage;
    const int hovered = static_cast<int>(g.HoveredId);
    const auto now_s = static_cast<float>(g.Time);
    if (memory.GetInt(thing) != hovered) memory.SetFloat(since, now_s);
    memory.SetInt(thing, hovered);
    return static_cast<double>(now_s - memory.GetFloat(since));
}

// Previews wait for a hovering mouse and held keys repeat: both need frames without input.
void ask_for_what_imgui_needs(Frame& frame)
{
    constexpr double preview_patience_s = 0.32, repeat_s = 0.04;
    ImGuiContext& g = *ImGui::GetCurrentContext();
    const double hovered_s = hovered_for_s(g);
    if (g.HoveredId != 0 && hovered_s < preview_patience_s)
        frame.again_in(preview_patience_s - hovered_s + 0.01);
    // A tooltip or menu that has just opened is measured in one frame and seen in the next.
    for (const ImGuiWindow* window : g.Windows)
        if (window->Active &&
            (window->HiddenFramesCanSkipItems > 0 || window->HiddenFramesCannotSkipItems > 0))
            frame.again_in(0);
    const auto down = [](bool held) { return held; };
    const bool* keys = g.IO.KeysDown;
    if (std::any_of(keys + key_right, keys + key_up + 1, down) ||
        (g.IO.WantTextInput && std::any_of(keys, keys + key_count, down)))
        frame.again_in(repeat_s);
}

// Menus and lists are gone through with the arrows and Enter. Panels and dialogs have the keyboard
// in their own hands.
void let_menus_have_the_keyboard()
{
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    const bool menu = !open.empty() && open.back().Window &&
                      (open.back().Window->Flags & ImGuiWindowFlags_Modal) == 0;
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = menu ? flags | ImGuiConfigFlags_NavEnableKeyboard
                 : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    if (!menu) GImGui->NavDisableHighlight = true;
    // Here Enter chooses, as the space bar does.
    const ImGuiIO& io = ImGui::GetIO();
    if (menu && (io.KeysDown[key_enter] || io.KeysDown[key_keypad_enter]))
        ImGui::GetIO().NavInputs[ImGuiNavInput_Activate] = 1;
}

// A menu that was opened by a key shows at once which entry Enter would choose.
void begin_at_first_entry()
{
    ImGuiContext& g = *GImGui;
    const ImVector<ImGuiPopupData>& open = g.OpenPopupStack;
    if (open.empty() || !g.NavWindow || open.back().Window != g.NavWindow ||
        (g.NavWindow->Flags & ImGuiWindowFlags_Modal) != 0)
        return;
    g.NavLayer = ImGuiNavLayer_Main;
    ImGui::NavInitWindow(g.NavWindow, true);
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
}

// Whether the last thing that hands did was to press a key.
bool by_key(bool before, const std::vector<Event>& events)
{
    for (const Event& event : events) {
        if (event.kind == Event::Kind::button || event.kind == Event::Kind::move) before = false;
        if (event.kind == Event::Kind::key && event.down) before = true;
    }
    return before;
}

} // namespace

struct Gui::Contexts {
    Contexts()
    {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr; // layout is the editor's to keep
        io.LogFilename = nullptr;
        io.ConfigInputTextCursorBlink = false; // a blinking cursor would keep an idle window busy
        io.ConfigDragClickToInputText = true;  // a click on a number types, a drag drags
        io.MouseDragThreshold = 3;
        map_keys();
        use_gpu();
    }
    static void use_gpu()
    {
        if (!ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Init("#version 330");
    }
    static void forget_gpu()
    {
        // Not its device objects alone: it would remember how large its buffers were.
        if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
    }
    ~Contexts()
    {
        forget_gpu();
        ImGui::DestroyContext();
    }
    Contexts(const Contexts&) = delete;
    Contexts& operator=(const Contexts&) = delete;
};

Gui::Gui(const ThemeOptions& options)
    : contexts_(std::make_unique<Contexts>()),
      theme_(apply_theme(options))
{
    ImGui::GetIO().UserData = this;
}

Gui::~Gui() = default;

Input& hands()
{
    return static_cast<Gui*>(ImGui::GetIO().UserData)->input_;
}

Tooltips& tooltips()
{
    return static_cast<Gui*>(ImGui::GetIO().UserData)->tooltips_;
}

void Gui::set_theme(const ThemeOptions& options)
{
    theme_ = apply_theme(options);
    ImGui_ImplOpenGL3_DestroyFontsTexture(); // made again, from the new atlas, by the next frame
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Gui::forget_gpu()
{
    Contexts::forget_gpu();
}

Frame Gui::frame(glm::ivec2 size_px, double time_s, bool close_asked, const DrawFrame& body)
{
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
    const double passed = last_time_s_ < 0 ? 1.0 / 60 : time_s - last_time_s_;
    // After a long idle the first frame must not think that a second passed under the mouse.
    io.DeltaTime = static_cast<float>(std::clamp(passed, 1e-4, 0.6));
    last_time_s_ = time_s;

    by_key_ = by_key(by_key_, input_.events()); // what opened since
    input_.begin_frame(time_s, {theme_.look.double_click_s, theme_.look.click_holds});
    Contexts::use_gpu();
    let_menus_have_the_keyboard();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    std::vector<unsigned> popups;
    for (const ImGuiPopupData& each : GImGui->OpenPopupStack) popups.push_back(each.PopupId);
    if (by_key_ && popups != popups_ && popups.size() >= popups_.size()) begin_at_first_entry();
    popups_ = std::move(popups);
    Frame frame{theme_, input_.events(), glm::vec2(size_px), time_s, close_asked};
    body(frame);
    tooltips_.draw(theme_, frame);
    ImGui::Render();

    glViewport(0, 0, size_px.x, size_px.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    ask_for_what_imgui_needs(frame);
    if (input_.pending()) frame.again_in(0);
    return frame;
}

} // namespace trivar::ui
