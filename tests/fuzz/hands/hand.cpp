// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/hand.h"

#include "editor/jobs/background_evaluator.h"
#include "tests/fuzz/campaign.h"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::testing {
namespace {

constexpr double longest_rest_s = 30; // of all threads, until a gesture is answered

double seconds_of(clockid_t clock)
{
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

ui::Button button_named(const std::string& name)
{
    return name == "right"    ? ui::Button::right
           : name == "middle" ? ui::Button::middle
                              : ui::Button::left;
}

} // namespace

Hand::Hand(const std::filesystem::path& scene)
    : folder_(scene.parent_path()),
      rig_(std::make_unique<Rig>(glm::ivec2(720, 520), ui::ThemeOptions{},
                                 (folder_ / "unnamed").string()))
{
    editor().files.own_models_folder = std::filesystem::path(TRIVAR_BINARY_DIR) / "assets/models";
    editor().files.scenes_folder = editor().files.models_folder = folder_.string();
    rig_->draw_small();
    editor().session.replace_scene(SceneFile(scene.string()));
    settle();
}

void Hand::frame()
{
    const double begin_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    rig_->frames(1);
    longest_frame_s_ = std::max(longest_frame_s_, seconds_of(CLOCK_THREAD_CPUTIME_ID) - begin_s);
}

void Hand::drain()
{
    while (rig_->screen.input().pending()) frame();
    frame();
    if (patient_) wait_for_background(longest_rest_s);
}

// A hand that waits sees what each of its moves gave, so that what it does follows from the seed.
void Hand::wait_for_background(double at_most_s)
{
    const double begin_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    while (editor().session.evaluator().status().busy) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin_s < at_most_s) continue;
        editor().session.evaluator().cancel();
        throw Broken(fmt::format("the scene is worked on for more than {} s", at_most_s));
    }
}

// Names the work that has not ended; empty: none.
std::string Hand::going_on()
{
    const Session& session = editor().session;
    if (rig_->screen.input().pending()) return "events wait";
    if (const auto job = session.jobs().status()) return job->what;
    if (const auto job = rig_->editor.session.quiet_jobs().status()) return job->what;
    if (session.committing()) return "a stroke is to be committed";
    return session.up_to_date() ? "" : "what is shown is not up to date";
}

void Hand::settle()
{
    constexpr int most_playing = 40; // frames, of what moves by itself
    const double begin_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    for (int frames = 0;; ++frames) {
        frame();
        const std::string what = going_on();
        if (what.empty() || (editor().playback.playing() && frames > most_playing)) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(frames < most_playing ? 0 : 2));
        wait_for_background(longest_rest_s);
        if (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin_s > longest_rest_s)
            throw Broken(fmt::format("the window does not rest in {} s: {}", longest_rest_s, what));
    }
    frame();
}

void Hand::strike(const ui::Chord& chord)
{
    const std::pair<bool, int> held[]{{chord.ctrl, ui::key_left_control},
                                      {chord.shift, ui::key_left_shift},
                                      {chord.alt, ui::key_left_alt}};
    for (const auto& [is, key] : held)
        if (is) push(ui::press_key(key));
    push(ui::press_key(chord.key));
    push(ui::press_key(chord.key, false));
    for (const auto& [is, key] : held)
        if (is) push(ui::press_key(key, false));
    drain();
}

void Hand::strike(const std::string& key, int times)
{
    const std::optional<ui::Chord> chord = ui::chord_from(key);
    for (int i = 0; chord && i < times; ++i) strike(*chord);
}

void Hand::type(const std::string& text)
{
    constexpr std::size_t most_struck = 60; // the rest is pasted in
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const int key = std::toupper(c);
        if (i < most_struck && c < 127) push(ui::press_key(key));
        push(ui::type_text(c));
        if (i < most_struck && c < 127) push(ui::press_key(key, false));
    }
    drain();
}

void Hand::hold(const std::vector<std::string>& keys, bool down)
{
    for (const std::string& key : keys)
        push(ui::press_key(key == "Ctrl"    ? ui::key_left_control
                           : key == "Shift" ? ui::key_left_shift
                                            : ui::key_left_alt,
                           down));
    if (!keys.empty()) drain();
}

ui::Rect Hand::place_of_object(int number) const
{
    const ui::Rect view = rig_->layout().view;
    const Evaluation& shown = rig_->editor.session.evaluated();
    if (shown.objects.empty()) return view;
    const auto count = static_cast<int>(shown.objects.size());
    const EvaluatedObject& object = *std::next(shown.objects.begin(), number % count)->second;
    const Box& box = *object.bounds;
    if (box.empty()) return view;
    ui::Rect out{glm::vec2(1e9f), glm::vec2(-1e9f)};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                           corner & 4 ? box.hi.z : box.lo.z);
        const glm::vec2 seen = rig_->seen_at(p);
        out.lo = glm::min(out.lo, seen);
        out.hi = glm::max(out.hi, seen);
    }
    out.lo = glm::clamp(out.lo, view.lo, view.hi);
    out.hi = glm::clamp(out.hi, view.lo, view.hi);
    return out;
}

ui::Rect Hand::place(const Gesture& gesture) const
{
    const Layout layout = rig_->layout();
    const std::string& area = gesture.area;
    const ui::Rect window{{0, 0}, glm::vec2(rig_->size_px)};
    if (area == "object") return place_of_object(gesture.number);
    return area == "inspector"  ? layout.inspector
           : area == "outliner" ? layout.outliner
           : area == "options"  ? layout.options
           : area == "timeline" ? layout.timeline
           : area == "top"      ? layout.top
           : area == "tabs"     ? layout.tabs
           : area == "strip"    ? layout.strip
           : area == "status"   ? layout.status
           : area == "window"   ? window
                                : layout.view;
}

glm::vec2 Hand::at(const Gesture& gesture, std::size_t point) const
{
    const ui::Rect rect = place(gesture);
    return rect.lo + glm::vec2(gesture.points[point]) * rect.size();
}

void Hand::lose_focus()
{
    for (const bool gained : {false, true}) {
        ui::Event focus;
        focus.kind = ui::Event::Kind::focus;
        focus.down = gained;
        push(std::move(focus));
    }
    drain();
}

void Hand::resize(glm::ivec2 size_px)
{
    rig_->size_px = glm::clamp(size_px, 64, 2000);
    rig_->screen.resize(rig_->size_px);
    frame();
}

void Hand::come_between(const std::string& what)
{
    if (what.empty()) return;
    if (what == "focus") return lose_focus();
    if (what == "resize")
        return resize(rig_->size_px == glm::ivec2(720, 520) ? glm::ivec2(1000, 600)
                                                            : glm::ivec2(720, 520));
    if (what.starts_with("type ")) return type(what.substr(5));
    if (what == "wheel") {
        push(ui::turn_wheel(1));
        return drain();
    }
    if (what == "right" || what == "turn") {
        const ui::Button button = what == "right" ? ui::Button::right : ui::Button::middle;
        push(ui::press(button));
        if (what == "turn") push(ui::move_to(mouse_ + glm::vec2(40, 12)));
        push(ui::press(button, false));
        return drain();
    }
    strike(what);
}

void Hand::stroke(const Gesture& gesture)
{
    if (gesture.points.empty()) return;
    double time_s = rig_->screen.count() / 60.0;
    std::vector<glm::vec2> way{at(gesture, 0)};
    for (std::size_t i = 1; i < gesture.points.size(); ++i) {
        const glm::vec2 from = way.back(), to = at(gesture, i);
        for (int k = 1; k <= gesture.frames; ++k)
            way.push_back(
                glm::mix(from, to, static_cast<float>(k) / static_cast<float>(gesture.frames)));
    }
    const ui::Button button = button_named(gesture.button);
    const auto interrupted = static_cast<std::size_t>(gesture.at * static_cast<double>(way.size()));
    push(ui::move_to(mouse_ = way.front(), time_s));
    drain();
    push(ui::press(button));
    for (std::size_t i = 0; i < way.size(); ++i) {
        push(ui::move_to(mouse_ = way[i], time_s += 0.01));
        drain();
        if (i == interrupted) come_between(gesture.between);
    }
    if (!gesture.keeps) push(ui::press(button, false));
    drain();
}

void Hand::click(const Gesture& gesture)
{
    if (gesture.points.empty()) return;
    push(ui::move_to(mouse_ = at(gesture, 0)));
    drain();
    for (int i = 0; i < (gesture.twice ? 2 : 1); ++i) {
        push(ui::press(button_named(gesture.button)));
        push(ui::press(button_named(gesture.button), false));
    }
    drain();
    frame();
}

void Hand::choose(const Gesture& gesture)
{
    const std::size_t open = ImGui::GetCurrentContext()->OpenPopupStack.size();
    click(gesture);
    const ImVector<ImGuiPopupData>& now = ImGui::GetCurrentContext()->OpenPopupStack;
    if (std::size_t(now.size()) <= open || !now.back().Window || gesture.points.size() < 2) return;
    const ImGuiWindow& list = *now.back().Window;
    const glm::vec2 share(gesture.points[1]);
    push(ui::move_to(
        mouse_ = {list.Pos.x + share.x * list.Size.x, list.Pos.y + share.y * list.Size.y}));
    drain();
    push(ui::press(ui::Button::left));
    push(ui::press(ui::Button::left, false));
    drain();
}

void Hand::close_dialogs()
{
    constexpr int most_open = 4;
    for (int i = 0; i < most_open; ++i) {
        const bool popup =
            ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
        if (!popup && !editor().files.asking() && !editor().palette.open &&
            !ImGui::GetIO().WantTextInput)
            return;
        strike("Esc");
    }
}

void Hand::make(const Gesture& gesture)
{
    using Kind = Gesture::Kind;
    patient_ = !gesture.hasty;
    if (!gesture.blind) close_dialogs();
    if (!gesture.tool.empty()) strike(gesture.tool);
    hold(gesture.held, true);
    switch (gesture.kind) {
    case Kind::stroke: stroke(gesture); break;
    case Kind::click: click(gesture); break;
    case Kind::choose: choose(gesture); break;
    case Kind::wheel:
        if (!gesture.points.empty()) push(ui::move_to(mouse_ = at(gesture, 0)));
        drain();
        for (int i = 0; i < std::abs(gesture.number); ++i) {
            push(ui::turn_wheel(gesture.number > 0 ? 1.0f : -1.0f));
            drain();
        }
        break;
    case Kind::chord: strike(gesture.text, gesture.number); break;
    case Kind::type:
        type(gesture.text);
        strike(gesture.end);
        break;
    case Kind::field:
        click(gesture);
        type(gesture.text);
        strike(gesture.end);
        break;
    case Kind::palette:
        strike("F3");
        type(gesture.text);
        strike(gesture.end);
        break;
    case Kind::command: {
        strike("F3");
        type("Log");
        strike("Enter");
        const ui::Rect log = rig_->layout().inspector;
        push(ui::move_to({log.center().x, log.hi.y - 16}));
        push(ui::press(ui::Button::left));
        push(ui::press(ui::Button::left, false));
        drain();
        type(gesture.text);
        strike(gesture.end);
        break;
    }
    case Kind::drop:
        push(ui::drop_files({(folder_ / gesture.text).string()}));
        drain();
        break;
    case Kind::save:
        strike("Ctrl+Shift+S");
        strike("Ctrl+A");
        type(gesture.text);
        strike("Enter");
        break;
    case Kind::resize:
        if (!gesture.points.empty()) resize(glm::ivec2(gesture.points.front()));
        break;
    case Kind::focus: lose_focus(); break;
    case Kind::card: rig_->screen.lose_context([&] { editor().lose_context(); }); break;
    }
    hold(gesture.held, false);
    if (patient_) settle();
}

} // namespace trivar::testing
