// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/select.h"

#include "editor/hands/laid_motion.h"
#include "editor/hands/motion.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {

bool adds_to_selection()
{
    return ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
}

void select_by_click(Session& session, Id under)
{
    if (adds_to_selection())
        session.selected.toggle(under);
    else
        session.selected = under;
}

ToolState SelectTool::state() const
{
    const bool boxes = box_ == Box::armed || box_ == Box::drawn;
    return {.busy = boxes || handles_.busy(), .crosshair = boxes, .shows_volume_at_work = true};
}

void SelectTool::use(Session& session, const ViewportInput& input)
{
    if (box_ == Box::none &&
        handles_.use(session, input, placement_handles(session, *choice_, input.scale)))
        return;
    if (input.pressed) {
        corner_px_ = input.mouse;
        if (box_ == Box::armed)
            box_ = Box::drawn;
        else if (input.under == 0)
            box_ = Box::pressed;
        else
            select_by_click(session, input.under);
    }
    if (box_ == Box::pressed && glm::distance(input.mouse, corner_px_) > click_slip_px)
        box_ = Box::drawn;
    if (!input.released) return;
    if (box_ == Box::drawn) {
        const std::vector<Id> seen =
            input.seen_in(glm::min(corner_px_, input.mouse), glm::max(corner_px_, input.mouse));
        if (adds_to_selection())
            session.selected.add(seen);
        else
            session.selected.set(seen);
    } else if (box_ == Box::pressed) {
        select_by_click(session, 0);
    }
    box_ = Box::none;
}

void SelectTool::cancel(Session& session)
{
    handles_.cancel(session);
    box_ = Box::none;
}

void SelectTool::overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const
{
    handles_.paint(theme, input, placement_handles(session, *choice_, input.scale),
                   end_of_words(theme, input));
    if (box_ == Box::drawn) paint_choice_box(theme, input, corner_px_);
}

void paint_choice_box(const ui::Theme& theme, const ViewportInput& input,
                      const glm::dvec2& corner_px)
{
    const glm::dvec2 size = input.rect.size();
    const auto corner = [&](glm::dvec2 p) {
        return glm::round(input.rect.lo + glm::vec2(glm::clamp(p, glm::dvec2(0), size)));
    };
    const glm::vec2 a = corner(corner_px), b = corner(input.mouse);
    const ui::Rect box{glm::min(a, b), glm::max(a, b)};
    ui::paint_box(box, ui::faded(theme.color.selected, 0.08f));
    ui::paint_rim(box.grown(theme.size.hairline), theme.color.halo, 0, theme.size.hairline);
    ui::paint_rim(box, theme.color.selected, 0, theme.size.hairline);
}

void SelectTool::options(Session& session, const ui::Theme& theme, float width)
{
    const std::size_t count = session.selected.size();
    const bool empty = session.document().objects.empty();
    const std::string words = empty        ? "Drop a model here, or add an object"
                              : count == 0 ? "Click an object to see what can be changed"
                              : count == 1 ? name_of(session.document(), session.selected)
                                           : std::to_string(count) + " objects, active: " +
                                                 name_of(session.document(), session.selected);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool handles = selected_placement(session) && width > theme.px(420);
    const float room = handles ? width - theme.px(320) : width;
    ui::name_text(theme.font.body, ui::rect_at({at.x, at.y}, {room, theme.size.row}),
                  theme.color.text_2, words);
    if (!handles) return;
    const float taken = std::min(room, ui::text_width(theme.font.body, words));
    ImGui::SetCursorScreenPos({at.x + taken + theme.px(24), at.y});
    if (const auto option = handles_option(session, theme, *choice_))
        ui::option_bar(theme, {*option}, width - taken - theme.px(24));
}

std::vector<Hint> SelectTool::hints(const Session& session) const
{
    if (box_ == Box::armed)
        return {{{"left"}, "Drag a box"},
                {{"Shift", "left"}, "Add to the selection"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (box_ == Box::drawn)
        return {{{"left"}, "Let go to select"},
                {{"Shift"}, "Add to the selection"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (handles_.busy() || handles_.hovers()) return handles_.hints();
    std::vector<Hint> hints{{{"left"}, "Select"}};
    if (!session.document().objects.empty()) {
        hints.push_back({{"Shift", "left"}, "Add or remove"});
        hints.push_back({{"left"}, "Drag a box"});
    }
    if (laid_stand(session) || !stands_of(session.document(), session.selected.ids()).empty()) {
        for (const char* tool : {"Move", "Rotate", "Scale"})
            hints.push_back({{std::string("@") + tool}, tool});
    }
    hints.push_back({{"middle"}, "Orbit"});
    hints.push_back({{"wheel"}, "Zoom"});
    return hints;
}

} // namespace trivar
