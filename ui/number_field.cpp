// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/expression.h"
#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "ui/input.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

// Between frames ImGui keeps small values for a window by id; a double takes two of its integers.
struct Memory {
    ImGuiID id;
    double get() const
    {
        const auto half = [this](ImGuiID i) {
            return std::uint64_t{
                static_cast<std::uint32_t>(ImGui::GetStateStorage()->GetInt(id + i))};
        };
        return std::bit_cast<double>(half(1) | half(2) << 32);
    }
    void set(double value) const
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        ImGui::GetStateStorage()->SetInt(id + 1, static_cast<int>(bits & 0xFFFFFFFFu));
        ImGui::GetStateStorage()->SetInt(id + 2, static_cast<int>(bits >> 32));
    }
    enum Mode { resting, pressed, dragging, typing };
    Mode mode() const { return static_cast<Mode>(ImGui::GetStateStorage()->GetInt(id)); }
    void set_mode(Mode mode) const { ImGui::GetStateStorage()->SetInt(id, mode); }
    float travel() const { return ImGui::GetStateStorage()->GetFloat(id + 3); }
    void set_travel(float px) const { ImGui::GetStateStorage()->SetFloat(id + 3, px); }
    bool refused() const { return ImGui::GetStateStorage()->GetBool(id + 4); } // what was typed
    void refuse(bool refused) const { ImGui::GetStateStorage()->SetBool(id + 4, refused); }
    // The reason why the typed text was not taken; it stays until the person does something else.
    enum Dropped { nothing, no_number, too_small, too_large };
    Dropped dropped() const
    {
        return static_cast<Dropped>(ImGui::GetStateStorage()->GetInt(id + 5));
    }
    void drop(Dropped what) const { ImGui::GetStateStorage()->SetInt(id + 5, what); }
};

// A drag gives values that people can read: four significant digits, or whole steps.
double handy(double value, double step)
{
    return step > 0 ? std::round(value / step) * step : rounded(value, 4);
}

double per_px(double start, const NumberStyle& style)
{
    if (style.bar_hi > style.lo) return (style.bar_hi - style.lo) * 0.01 / 4;
    if (style.step > 0) return style.step / 8;
    return std::max(std::abs(start), style.usual) * 0.01 / 4 * 2;
}

// Where a drag has come to that stops at a value for a while, pixels at scale 1.
double moved_past(double stop, double start, double travel_px, double per_px)
{
    constexpr double held_px = 60;
    const double free = start + travel_px * per_px;
    if (start > stop || free <= stop) return free;
    return std::max(stop, free - held_px * per_px);
}

// Returns the step of a drag while Ctrl is held: about a tenth of the value or of the range.
double round_step(double start, const NumberStyle& style)
{
    if (style.step > 0) return 5 * style.step;
    const bool bar = style.bar_hi > style.lo;
    const double size = bar ? style.bar_hi - style.lo : std::max(std::abs(start), style.usual);
    return std::pow(10, std::floor(std::log10(size)) - 1);
}

void paint_number(const Theme& theme, const Rect& r, double value, const NumberStyle& style,
                  bool hot)
{
    const Palette& c = theme.color;
    paint_box(r, hot ? c.field_hover : c.field, theme.size.rounding_small);
    const bool bar = style.bar_hi > style.lo, halts = !bar && style.stop < 1e300;
    if (bar || halts) { // up to where drags go, or halt
        const double whole = bar ? style.bar_hi - style.lo : style.stop - style.lo;
        const double share = whole > 0 ? std::clamp((value - style.lo) / whole, 0.0, 1.0) : 1;
        ImGui::PushClipRect({r.lo.x, r.lo.y},
                            {r.lo.x + r.width() * static_cast<float>(share), r.hi.y}, true);
        paint_box(r, c.field_fill, theme.size.rounding_small);
        ImGui::PopClipRect();
    }
    if (halts && value > style.stop)
        paint_rim(r, c.warn, theme.size.rounding_small, theme.size.hairline);
    Rect text = {r.lo + glm::vec2(theme.px(8), 0), r.hi - glm::vec2(theme.px(6), 0)};
    if (!style.axis.empty()) {
        text.lo.x -= theme.px(1);
        paint_text(theme.font.small_strong, text, style.axis_color ? style.axis_color : c.text_2,
                   style.axis);
        text.lo.x += std::max(theme.px(12), text_width(theme.font.small_strong, style.axis) +
                                                theme.px(4)); // W is wide
        text.hi.x += theme.px(3);
    }
    const bool word = !style.words.empty() || (value == 0 && !style.zero.empty());
    const ImFont* font = theme.font.body;
    const auto fits = [&](const std::string& shown) {
        return text_width(font, shown) <= text.width();
    };
    std::string shown = word ? style.words.empty() ? style.zero : style.words
                             : number_in_field(value, style.step, fits);
    if (word && !fits(shown)) shown = "–";
    if (!fits(shown)) {
        font = theme.font.small;
        shown = number_in_field(value, style.step, fits);
    }
    const float unit_width = text_width(theme.font.small, style.unit);
    if (!style.unit.empty() && style.words.empty() && text.width() > unit_width + theme.px(34) &&
        text_width(font, shown) + unit_width + theme.px(6) <= text.width()) {
        paint_text(theme.font.small, text, c.text_2, style.unit, Align::right);
        text.hi.x -= unit_width + theme.px(6);
    }
    paint_text(font, text, word ? c.text_2 : c.text, elided(font, shown, text.width()));
}

Measure measure_of(const NumberStyle& style)
{
    return style.unit == "m"     ? Measure::length
           : style.unit == "deg" ? Measure::angle
                                 : Measure::plain;
}

// Tab ends typing in one field of a window and begins it in the next that is drawn.
ImGuiID tab_key()
{
    return ImHashStr("the next number is typed");
}
void pass_on_typing()
{
    ImGui::ClearActiveID();
    ImGui::GetStateStorage()->SetInt(tab_key(), ImGui::GetFrameCount() + 1); // the first, if last
}
bool takes_typing()
{
    if (ImGui::GetStateStorage()->GetInt(tab_key(), -1) < ImGui::GetFrameCount()) return false;
    if (is_greyed()) return false;
    ImGui::GetStateStorage()->SetInt(tab_key(), -1);
    return true;
}

// Frames after which a field that is opened has the keyboard.
constexpr float keyboard_comes = 2;

// Returns the text when typing begins, without the noise of sums: -1.34 for -1.3399999999999999.
std::string typed_text(double value)
{
    const double clean = rounded(value, 12);
    return number_text(std::abs(clean - value) <= 1e-12 * std::abs(value) ? clean : value,
                       {.digits = 0, .commas = false});
}

// Returns why this value is not allowed; empty: it is.
std::string limit_words(double value, const NumberStyle& style)
{
    if (value >= style.lo && value <= style.hi) return {};
    const std::string unit = style.unit.empty() ? "" : " " + style.unit;
    constexpr double nearly_nothing = 1e-6; // a limit that stands for "above 0"
    if (value > style.hi) return "At most " + typed_text(style.hi) + unit + ".";
    if (style.lo > 0 && style.lo < nearly_nothing) return "More than 0" + unit + ".";
    return "At least " + typed_text(style.lo) + unit + ".";
}

Memory::Dropped dropped(std::optional<double> typed, const NumberStyle& style)
{
    return !typed ? Memory::no_number : *typed < style.lo ? Memory::too_small : Memory::too_large;
}

// Returns why the typed text was not taken, and what is there instead.
std::string dropped_words(Memory::Dropped what, double value, const NumberStyle& style)
{
    const std::string why = what == Memory::no_number   ? "This is not a number."
                            : what == Memory::too_small ? limit_words(style.lo - 1, style)
                                                        : limit_words(style.hi + 1, style);
    return why + " It stays " + typed_text(value) +
           (style.unit.empty() ? "." : " " + style.unit + ".");
}

bool hand_does_something()
{
    const ImGuiIO& io = ImGui::GetIO();
    return ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
           ImGui::IsMouseClicked(ImGuiMouseButton_Right) || io.MouseWheel != 0 ||
           struck_chord().has_value();
}

// Over everything, so that it needs no room in the panel.
void say_under(const Theme& theme, const Rect& field, const std::string& words)
{
    const glm::vec2 size{text_width(theme.font.small, words) + theme.px(16), theme.size.row};
    const float most = ImGui::GetIO().DisplaySize.x - size.x - theme.px(4);
    const glm::vec2 at{std::min(field.lo.x, most), field.hi.y + theme.px(3)};
    ImDrawList* over = ImGui::GetForegroundDrawList();
    over->AddRectFilled({at.x, at.y}, {at.x + size.x, at.y + size.y}, theme.color.raised,
                        theme.size.rounding_small);
    over->AddRect({at.x, at.y}, {at.x + size.x, at.y + size.y}, theme.color.bad,
                  theme.size.rounding_small, 0, theme.size.hairline);
    const float high = theme.font.small->FontSize;
    over->AddText(theme.font.small, high,
                  {at.x + theme.px(8), std::round(at.y + (size.y - high) / 2)}, theme.color.text,
                  words.c_str());
}

Edit type_number(const Theme& theme, const Memory& memory, double& value, const NumberStyle& style,
                 float width)
{
    const bool fresh = memory.travel() == 0;
    std::string text = typed_text(memory.get());
    // A text that was not taken is still there when the field is opened again.
    const ImGuiInputTextState* before = ImGui::GetInputTextState(ImGui::GetID("##typed"));
    if (memory.travel() < keyboard_comes && memory.refused() && before) text = before->TextA.Data;
    text.resize(64);
    // ImGui's own text field, of our height, opened with the keyboard in it.
    ImGui::SetNextItemWidth(width);
    if (fresh) ImGui::SetKeyboardFocusHere();
    memory.set_travel(memory.travel() + 1);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, theme.color.field_active);
    ImGui::InputText("##typed", text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleColor();
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    const std::optional<double> typed = evaluate_expression(text.c_str(), measure_of(style), value);
    memory.set(typed.value_or(value));                        // what cannot be read changes nothing
    const bool untouched = text.c_str() == typed_text(value); // then it is as exact as it was
    const std::string why_not = untouched ? ""
                                : typed   ? limit_words(*typed, style)
                                          : "This is not a number.";
    paint_rim({{lo.x, lo.y}, {hi.x, hi.y}}, why_not.empty() ? theme.color.focus : theme.color.bad,
              theme.size.rounding_small, 1.5f * theme.scale);
    if (!why_not.empty()) say_under(theme, {{lo.x, lo.y}, {hi.x, hi.y}}, why_not);
    const bool tab = ImGui::IsItemActive() && ImGui::IsKeyPressed(key_tab, false);
    if (ImGui::IsItemActive() && !tab) return Edit::none;
    if (memory.travel() <= keyboard_comes) return Edit::none;
    const bool enter =
        ImGui::IsKeyPressed(key_enter, false) || ImGui::IsKeyPressed(key_keypad_enter, false);
    memory.refuse(!why_not.empty() && (enter || tab));
    if (memory.refused()) { // it is typed on
        if (tab) ImGui::ClearActiveID();
        memory.set_travel(0);
        return Edit::none;
    }
    if (tab) pass_on_typing();
    memory.set_mode(Memory::resting);
    const double result = memory.get();
    const bool escaped = ImGui::IsKeyPressed(key_escape, false);
    if (!why_not.empty() && !escaped) memory.drop(dropped(typed, style));
    if (untouched || !why_not.empty() || result == value || escaped) return Edit::none;
    value = result;
    return Edit::changed;
}

// Offers, on the right button, to copy the value and to paste one.
Edit value_menu(double& value, const NumberStyle& style)
{
    const bool commands = offers_commands();
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("value menu");
    if (!ImGui::BeginPopup("value menu")) return Edit::none;
    Edit edit = Edit::none;
    if (ImGui::MenuItem("Copy value")) ImGui::SetClipboardText(typed_text(value).c_str());
    const char* text = ImGui::GetClipboardText();
    const auto pasted = evaluate_expression(text ? text : "", measure_of(style), value);
    const bool fits = pasted && limit_words(*pasted, style).empty();
    if (ImGui::MenuItem("Paste value", nullptr, false, fits) && *pasted != value) {
        value = *pasted;
        edit = Edit::changed;
    }
    if (commands && ImGui::MenuItem(copy_command_words)) edit = Edit::copied;
    ImGui::EndPopup();
    return edit;
}

} // namespace

void type_next_number()
{
    ImGui::GetStateStorage()->SetInt(tab_key(), ImGui::GetFrameCount() + 1);
}

std::string number_in_field(double value, double step,
                            const std::function<bool(const std::string&)>& fits)
{
    constexpr int most = 6, usual = 4; // digits: of what was typed, and of what was computed
    if (step >= 1 && value == std::round(value))
        return number_text(value, {.digits = 0, .commas = false});
    const bool typed = std::abs(value - rounded(value, most)) <= 1e-9 * std::abs(value);
    const auto of_digits = [&](int digits) {
        return number_text(value, {.digits = digits, .decimals = 2, .commas = false});
    };
    std::string shown = of_digits(typed ? most : usual);
    for (int digits = most - 1; digits > 0 && !fits(shown); --digits) {
        if (typed || digits < usual) shown = of_digits(digits);
    }
    // Small ones have more zeros than fit, large ones digits.
    for (int digits = 3; digits > 0 && !fits(shown); --digits)
        shown = number_text(value, {.digits = digits, .power = true});
    return shown;
}

std::string short_number(double value)
{
    return number_text(value, {.decimals = 2});
}

NumberStyle percent_style(double lo, double hi)
{
    return {.lo = lo, .hi = hi, .bar_hi = lo >= 0 ? hi : -1e300, .unit = "%", .factor = 100};
}

Edit number_field(const Theme& theme, const std::string& id, double& value,
                  const NumberStyle& style, float width)
{
    if (style.factor != 1) {
        NumberStyle shown = style;
        for (double* each :
             {&shown.lo, &shown.hi, &shown.bar_hi, &shown.step, &shown.stop, &shown.usual})
            *each *= style.factor;
        shown.factor = 1;
        double number = value * style.factor;
        const Edit edit = number_field(theme, id, number, shown, width);
        if (edit == Edit::changed || edit == Edit::cancelled) value = number / style.factor;
        return edit;
    }
    ImGui::PushID(id.c_str());
    const Memory memory{ImGui::GetID("number")};
    Edit edit = Edit::none;
    if (memory.mode() == Memory::resting && takes_typing()) {
        memory.set(value);
        memory.set_travel(0);
        memory.set_mode(Memory::typing);
    }
    if (memory.mode() == Memory::typing) {
        edit = type_number(theme, memory, value, style, width);
        ImGui::PopID();
        return edit;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect rect = rect_at({at.x, at.y}, {width, theme.size.row});
    ImGui::InvisibleButton("drag", {std::max(1.0f, width), theme.size.row});
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActivated()) {
        memory.set(value);
        memory.set_travel(0);
        memory.set_mode(Memory::pressed);
    }
    if (ImGui::IsItemActive()) {
        const ImGuiIO& io = ImGui::GetIO();
        hands().may_hold_on();
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) memory.set_mode(Memory::dragging);
        if (memory.mode() == Memory::dragging) {
            memory.set_travel(memory.travel() + io.MouseDelta.x * (io.KeyShift ? 0.1f : 1.0f));
            const double start = memory.get();
            const double moved =
                moved_past(style.stop, start, memory.travel() / theme.scale, per_px(start, style));
            const double step = io.KeyCtrl ? round_step(start, style) : style.step;
            const double next =
                std::clamp(moved == style.stop ? moved : handy(moved, step), style.lo, style.hi);
            if (next != value && memory.travel() != 0) edit = Edit::changed;
            if (edit == Edit::changed) value = next;
        }
        if (ImGui::IsKeyPressed(key_escape, false)) {
            value = memory.get();
            memory.set_mode(Memory::resting);
            ImGui::ClearActiveID();
            edit = Edit::cancelled;
        }
    } else if (memory.mode() == Memory::pressed) { // let go without a drag: type
        memory.set_mode(Memory::typing);
        memory.set_travel(0);
    } else {
        memory.set_mode(Memory::resting);
    }
    if (const Edit by_menu = value_menu(value, style); by_menu != Edit::none) edit = by_menu;
    paint_number(theme, rect, value, style, hot);
    if (memory.dropped() != Memory::nothing) {
        say_under(theme, rect, dropped_words(memory.dropped(), value, style));
        if (hand_does_something() || edit != Edit::none) memory.drop(Memory::nothing);
    }
    ImGui::PopID();
    return edit;
}

Edit integer_field(const Theme& theme, const std::string& id, int& value, const NumberStyle& style,
                   float width)
{
    double number = value;
    NumberStyle whole = style;
    whole.step = std::max(1.0, std::round(style.step));
    const Edit edit = number_field(theme, id, number, whole, width);
    const int result = static_cast<int>(
        std::clamp(std::round(number), std::max(style.lo, -2e9), std::min(style.hi, 2e9)));
    if (edit == Edit::changed && result == value) return Edit::none;
    value = result;
    return edit;
}

} // namespace trivar::ui
