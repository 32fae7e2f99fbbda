// SPDX-License-Identifier: GPL-3.0-or-later
// What a tool that works on control points shows.
#include "editor/hands/points_tool.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "ui/widgets.h"

#include <algorithm>

namespace trivar {

void PointsTool::paint_points(const Session& session, const ui::Theme& theme,
                              const ViewportInput& input) const
{
    std::vector<float> shares(at_world_.size());
    if (gesture_ && proportional_) shares = this->shares();
    for (const int i : chosen_) shares[static_cast<std::size_t>(i)] = 1;
    const bool many = at_world_.size() > many_handles,
               too_many = at_world_.size() > most_shown_points;
    struct Seen {
        std::size_t point;
        PicturePoint at;
        bool meant; // it is chosen, lit, or near the mouse
    };
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < at_world_.size(); ++i) {
        const PicturePoint p = project(session.view.camera, at_world_[i]);
        const bool meant = shares[i] > 0 || hovered_ == static_cast<int>(i) ||
                           glm::distance(p.p_px, input.mouse) < handles_near_px * input.scale;
        if (p.depth_world > 0 && (meant || !too_many) && seen.size() < most_shown_points)
            seen.push_back({i, p, meant});
    }
    std::ranges::stable_sort(seen, std::ranges::greater{},
                             [](const Seen& each) { return each.at.depth_world; });
    for (const auto& [point, p, meant] : seen) {
        const glm::vec2 at = input.rect.lo + glm::vec2(p.p_px);
        const auto number = static_cast<int>(point);
        if (many && !meant)
            ui::paint_dot(at, 1.5f * theme.scale, ui::faded(theme.color.lattice, 0.6f), 0, 0);
        else
            paint_point(theme, number,
                        {at, 1 / pixel_size_world(session.view.camera, p.depth_world),
                         shares[point], hovered_ == number});
    }
}

void PointsTool::overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const
{
    const EvaluatedObject* shown = seen(session);
    if (!shown || shown->id != object_) return; // it was selected after the points were looked at
    paint_points(session, theme, input);
    if (box_px_ && glm::distance(*box_px_, input.mouse) >= click_slip_px)
        paint_choice_box(theme, input, *box_px_);
    if (chosen_.empty() || box_px_) return;
    paint_gizmo(theme, input.rect.lo,
                gizmo_shapes(gesture_ ? gesture_->kind() : MotionKind::move, session.view.camera,
                             frame(session), input.scale),
                gesture_ ? gesture_->constraint() : hovered_handle_);
    if (gesture_) paint_motion(session, theme, input);
}

void PointsTool::paint_words(const ui::Theme& theme, const ViewportInput& input,
                             const std::string& words, bool stopped)
{
    ui::paint_chip(theme,
                   input.rect.lo + glm::vec2(input.mouse) + glm::vec2(theme.px(18), -theme.px(30)),
                   {words, stopped ? theme.color.bad : ui::Color{0}});
}

void PointsTool::add_proportional_option(std::vector<ui::Option>& options, const ui::Theme& theme)
{
    options.push_back(
        ui::check_option(theme, "Proportional", "proportional", proportional_,
                         "Nearby points follow the selected ones, less with distance."));
}

std::vector<Hint> PointsTool::hints(const Session& session) const
{
    if (gesture_) {
        std::vector<Hint> out = gesture_.hints(axes_words(session));
        if (proportional_) out.insert(out.begin() + 2, {{"wheel"}, "Radius"});
        out.insert(out.begin() + 3, {{"O"}, "Neighbours"});
        return out;
    }
    std::vector<Hint> out{{{"left"}, chosen_.empty() ? "Select a point" : "Drag a point or handle"},
                          {{"Ctrl", "left"}, "Add or remove"},
                          {{"left"}, "Drag a box"},
                          {{"@Proportional editing"}, "Neighbours too"},
                          {{"Esc"}, "Select"}};
    if (!chosen_.empty())
        out.insert(out.begin() + 1, {{"@Move", "@Rotate", "@Scale"}, "With the mouse"});
    if (at_world_.size() > most_shown_points)
        out.insert(out.begin(), {{}, "Too many points: showing those near the pointer"});
    return out;
}

} // namespace trivar
