// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_dialog.h"

#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/keys.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace fs = std::filesystem;
namespace {

std::string size_text(std::uintmax_t bytes)
{
    const auto b = static_cast<double>(bytes);
    if (b < 1e3) return fmt::format("{} B", bytes);
    if (b < 1e6) return fmt::format("{:.0f} KB", b / 1e3);
    return b < 1e9 ? fmt::format("{:.1f} MB", b / 1e6) : fmt::format("{:.1f} GB", b / 1e9);
}

bool is_folder(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

// Lets typing replace the name and keep its extension; false: the field has no keyboard yet.
bool select_stem(const std::string& name)
{
    ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetActiveID());
    if (!state) return false;
    const fs::path path(name);
    const auto letters_before = [&](std::size_t end) {
        return ImTextCountCharsFromUtf8(name.data(), name.data() + end);
    };
    const std::size_t file = name.size() - path.filename().string().size();
    state->Stb.select_start = letters_before(file);
    state->Stb.select_end = state->Stb.cursor = letters_before(file + path.stem().string().size());
    return true;
}

} // namespace

void FileDialog::open(FileRequest request, const fs::path& start)
{
    request_ = std::move(request);
    open_ = just_opened_ = true;
    focus_ = Focus::field;
    typed_ = request_.name;
    select_stem_ = request_.saving;
    std::error_code ignored;
    fs::path folder = is_folder(start) ? start : next_folder_;
    if (!is_folder(folder)) folder = fs::current_path(ignored);
    enter(folder);
}

void FileDialog::ask_again(std::string problem)
{
    open_ = just_opened_ = true;
    focus_ = Focus::field;
    problem_ = std::move(problem);
}

void FileDialog::enter(const fs::path& folder)
{
    std::error_code ignored;
    const fs::path real = fs::weakly_canonical(folder, ignored);
    folder_ = real.empty() ? folder : real;
    entries_ = entries_of(folder_, request_.extensions);
    if (request_.folder)
        std::erase_if(entries_, [](const FileEntry& each) { return !each.folder; });
    selected_ = -1;
    problem_.clear();
    if (!request_.saving) typed_.clear();
}

fs::path FileDialog::absolute(const std::string& typed) const
{
    const char* home = std::getenv("HOME");
    if (home && (typed == "~" || typed.starts_with("~/"))) return home + typed.substr(1);
    const fs::path path(typed);
    return path.is_absolute() ? path : folder_ / path;
}

fs::path FileDialog::with_extension(fs::path path) const
{
    if (request_.saving && path.extension().empty() && !request_.extensions.empty())
        path += request_.extensions.front();
    return path;
}

bool FileDialog::replaces() const
{
    std::error_code ignored;
    return request_.saving && !request_.folder && !typed_.empty() && !is_folder(absolute(typed_)) &&
           fs::exists(with_extension(absolute(typed_)), ignored);
}

std::optional<std::string> FileDialog::take(const std::string& typed, bool replace)
{
    if (typed.empty()) return std::nullopt;
    fs::path path = absolute(typed);
    if (is_folder(path)) {
        enter(path);
        typed_.clear();
        just_opened_ = true; // what is typed next is a path
        return std::nullopt;
    }
    path = with_extension(std::move(path));
    std::error_code ignored;
    const bool there = fs::exists(path, ignored);
    if (!request_.saving && !there) {
        problem_ = "There is no file of this name.";
        return std::nullopt;
    }
    if (request_.saving && !is_folder(path.parent_path())) {
        problem_ = "There is no such folder.";
        return std::nullopt;
    }
    // Scanners name files by numbers, such as 1.2.840.7; what these are their readers find.
    const std::string ending = path.extension().string();
    const bool named = request_.saving || std::ranges::any_of(ending, [](unsigned char c) {
                           return std::isalpha(c) != 0;
                       });
    if (named && !has_extension(path.filename().string(), request_.extensions)) {
        problem_ = "The name must end in ";
        for (const std::string& e : request_.extensions)
            problem_ += (&e == &request_.extensions.front() ? "" : ", ") + e;
        problem_ += ".";
        return std::nullopt;
    }
    if (request_.saving && there && !replace) {
        problem_ = path.filename().string() +
                   " exists already. Press Replace or Ctrl Enter, or type another name.";
        return std::nullopt;
    }
    next_folder_ = path.parent_path();
    open_ = false;
    return path.string();
}

// The one of the typed name, or the one that is shown.
std::optional<std::string> FileDialog::take_folder()
{
    const fs::path path = typed_.empty() ? folder_ : absolute(typed_).lexically_normal();
    std::error_code ignored;
    if (fs::exists(path, ignored) && !is_folder(path)) {
        problem_ = "There is a file of this name.";
        return std::nullopt;
    }
    next_folder_ = folder_;
    open_ = false;
    return path.string();
}

std::optional<std::string> FileDialog::draw_list(const Theme& theme, float height)
{
    const Palette& c = theme.color;
    std::optional<std::string> chosen;
    bool scroll = false;
    const int count = static_cast<int>(entries_.size());
    if (!ImGui::GetIO().WantTextInput || ImGui::IsKeyPressed(key_down) ||
        ImGui::IsKeyPressed(key_up)) {
        const int step = ImGui::IsKeyPressed(key_down) ? 1 : ImGui::IsKeyPressed(key_up) ? -1 : 0;
        if (step != 0 && count > 0) {
            selected_ = std::clamp(selected_ + step, 0, count - 1);
            scroll = true;
        }
    }
    ImGui::PushStyleColor(ImGuiCol_ChildBg, c.base);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("entries", {0, height});
    for (int i = 0; i < count; ++i) {
        const FileEntry& entry = entries_[static_cast<std::size_t>(i)];
        ImGui::PushID(i);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const Rect row = rect_at({at.x, at.y}, {ImGui::GetContentRegionAvail().x, theme.px(28)});
        const bool pressed =
            ImGui::InvisibleButton("entry", {row.width(), row.height()}) && !entered_;
        const Rect band = {row.lo + glm::vec2(theme.px(4), 0), row.hi - glm::vec2(theme.px(4), 0)};
        if (i == selected_)
            paint_box(band, c.row_selected, theme.size.rounding_small);
        else if (ImGui::IsItemHovered())
            paint_box(band, c.row_hover, theme.size.rounding_small);
        if (i == selected_ && scroll) ImGui::SetScrollHereY();
        const Rect in = {band.lo + glm::vec2(theme.px(10), 0),
                         band.hi - glm::vec2(theme.px(10), 0)};
        paint_text(theme.font.body, in, entry.folder ? c.accent_text : c.text_2,
                   entry.folder ? icon::folder : icon::file);
        paint_text(theme.font.body, {in.lo + glm::vec2(theme.px(26), 0), in.hi}, c.text,
                   elided(theme.font.body, entry.name, in.width() - theme.px(110)));
        if (!entry.folder)
            paint_text(theme.font.small, in, i == selected_ ? c.text_2 : c.text_3,
                       size_text(entry.bytes), Align::right);
        const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
        ImGui::PopID();
        if (pressed || twice) {
            selected_ = i;
            problem_.clear();
            if (!entry.folder || request_.folder) typed_ = entry.name;
        }
        if (twice) {
            chosen = entry.name;
            entered_ = true;
            break; // taking it may change the list
        }
    }
    if (!chosen && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) entered_ = false;
    if (count == 0) {
        const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
        empty_state(theme, rect_at({at.x, at.y}, {size.x, size.y}), icon::folder, "Nothing here",
                    request_.folder ? "This folder has no others in it."
                                    : "This folder has no file that can be used here.");
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return chosen ? take(*chosen) : std::nullopt;
}

// Tab goes from the field to the buttons and round; a click on anything ends that.
void FileDialog::move_focus()
{
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) focus_ = Focus::field;
    if (ImGui::IsKeyPressed(key_tab, false)) {
        const int on = ImGui::GetIO().KeyShift ? 3 : 1;
        const auto next = [&] { focus_ = static_cast<Focus>((static_cast<int>(focus_) + on) % 4); };
        next();
        if (focus_ == Focus::option && request_.option.empty()) next();
        just_opened_ = just_opened_ || focus_ == Focus::field; // the keyboard goes there
    }
    // ImGui's own way of going on by Tab knows fields only.
    if (focus_ != Focus::field && !ImGui::IsMouseDown(ImGuiMouseButton_Left))
        ImGui::ClearActiveID();
}

std::optional<std::string> FileDialog::draw(const Theme& theme)
{
    if (!open_) return std::nullopt;
    std::optional<std::string> chosen;
    const bool nothing_typed = typed_.empty(); // before this frame's keys
    const Rect rect = begin_dialog(theme, "files", {theme.px(640), theme.px(520)});
    const float pad = theme.px(24), left = rect.lo.x + pad, width = rect.width() - 2 * pad;
    const auto at = [&](float x, float y) { ImGui::SetCursorScreenPos({x, y}); };
    float y = rect.lo.y + theme.px(20);
    paint_text(theme.font.title, {{left, y}, {rect.hi.x, y + theme.px(24)}}, theme.color.text,
               request_.title);
    y += theme.px(36);
    const glm::vec2 square(theme.size.icon_button);
    at(left, y);
    if (icon_button(theme, "up", icon::level_up, square, {"Folder above", "Backspace"}))
        enter(folder_.parent_path());
    at(left + theme.px(28), y);
    const char* home = std::getenv("HOME");
    if (icon_button(theme, "home", icon::home, square, {"Home folder"}) && home) enter(home);
    const std::string shown = folder_.string();
    paint_text(theme.font.body, {{left + theme.px(64), y}, {rect.hi.x - pad, y + theme.size.row}},
               theme.color.text_2, elided(theme.font.body, shown, width - theme.px(64)));
    y += theme.px(32);
    const float list_height = rect.hi.y - y - theme.px(128);
    ImGui::SetCursorScreenPos({left, y});
    ImGui::PushClipRect({left, y}, {rect.hi.x - pad, rect.hi.y}, true);
    ImGui::BeginChild("list", {width, list_height});
    chosen = draw_list(theme, list_height);
    ImGui::EndChild();
    ImGui::PopClipRect();
    y += list_height + theme.px(12);
    at(left, y);
    move_focus();
    if (just_opened_) ImGui::SetKeyboardFocusHere();
    just_opened_ = false;
    ImGui::PushAllowKeyboardFocus(focus_ == Focus::field); // else Tab lights it once more
    if (text_field(theme, "path", typed_, request_.saving ? "Name" : "Type or paste a path", width,
                   request_.folder ? icon::folder : icon::file) == Edit::changed) {
        problem_.clear();
        selected_ = -1;
    }
    ImGui::PopAllowKeyboardFocus();
    if (select_stem_ && select_stem(typed_)) select_stem_ = false;
    y += theme.px(32);
    for (const std::string& line : wrapped(theme.font.small, problem_, width)) {
        paint_text(theme.font.small, {{left, y}, {rect.hi.x - pad, y + theme.px(16)}},
                   theme.color.warn, line);
        y += theme.px(16);
    }
    const bool replacing = replaces();
    const std::string action = replacing ? "Replace" : request_.action;
    const float ok = button_width(theme, action), no = button_width(theme, "Cancel");
    const float bottom = rect.hi.y - theme.px(20) - theme.px(32);
    const bool enter_key =
        ImGui::IsKeyPressed(key_enter, false) || ImGui::IsKeyPressed(key_keypad_enter, false);
    const auto ring = [&](const Rect& r) {
        paint_rim(r.grown(theme.px(2)), theme.color.focus, theme.size.rounding + theme.px(2),
                  1.5f * theme.scale);
    };
    if (!request_.option.empty()) {
        const float x = rect.lo.x + pad, row = bottom + theme.px(4);
        at(x, row);
        check_box(theme, "option", request_.option_on, request_.option);
        if (focus_ == Focus::option) {
            ring(rect_at({x, row + theme.px(4)}, glm::vec2(theme.px(16))));
            if (ImGui::IsKeyPressed(key_space, false)) request_.option_on = !request_.option_on;
        }
    }
    // A button, with a ring where it has the keyboard; then Enter and the space bar press it.
    const auto walked = [&](float x, const std::string& words, ButtonKind kind, Focus mine) {
        at(x, bottom);
        const bool pressed = button(theme, words, kind);
        if (focus_ != mine) return pressed;
        ring(rect_at({x, bottom}, {button_width(theme, words), theme.px(32)}));
        return pressed || enter_key || ImGui::IsKeyPressed(key_space, false);
    };
    const bool pressed = walked(rect.hi.x - pad - ok, action,
                                replacing ? ButtonKind::danger : ButtonKind::primary, Focus::agree);
    const bool cancelled = walked(rect.hi.x - pad - ok - theme.px(8) - no, "Cancel",
                                  ButtonKind::plain, Focus::cancel) ||
                           ImGui::IsKeyPressed(key_escape, false);
    const bool agreed = enter_key && focus_ != Focus::cancel;
    const bool replace = replacing && (pressed || ImGui::GetIO().KeyCtrl);
    if (!chosen && open_ && (pressed || agreed)) {
        const bool from_list = selected_ >= 0 && (typed_.empty() || !request_.saving);
        chosen = request_.folder
                     ? take_folder()
                     : take(from_list ? entries_[static_cast<std::size_t>(selected_)].name : typed_,
                            replace && !from_list);
        just_opened_ = open_; // typing goes on where Enter took the keyboard away
        focus_ = Focus::field;
    }
    if (!request_.take_folder.empty()) {
        at(left, bottom);
        if (button(theme, request_.take_folder, ButtonKind::plain, {0, 0}, icon::folder) && open_) {
            const auto i = static_cast<std::size_t>(selected_);
            const bool of_list = selected_ >= 0 && entries_[i].folder;
            chosen = (of_list ? folder_ / entries_[i].name : folder_).string();
            next_folder_ = folder_;
            open_ = false;
        }
    }
    if (open_ && nothing_typed && ImGui::IsKeyPressed(key_backspace, false))
        enter(folder_.parent_path());
    if (cancelled) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    end_dialog();
    return chosen;
}

} // namespace trivar::ui
