// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/lattice_points.h"

#include "editor/hands/last_shaping.h"
#include "editor/hands/select.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/shown_points.h"
#include "editor/picture/volume_picture.h"
#include "ui/widgets.h"

#include <limits>

namespace trivar {
namespace {

constexpr double shown_reach_px = 90; // of the mouse, at scale 1

// Those within are fainter, so that the box reads as one.
bool on_shell(const Lattice& volume, const glm::ivec3& p)
{
    const glm::ivec3 last = point_count(volume) - 1;
    return glm::any(glm::equal(p, glm::ivec3(0))) || glm::any(glm::equal(p, last));
}

// A dot on a dark one, so that it stands out on any ground.
void paint_point(const ui::Theme& theme, glm::vec2 at, float radius, ui::Color color)
{
    const float alpha = static_cast<float>(color >> 24) / 255;
    ui::paint_dot(at, theme.scale * (radius + 1.25f), ui::faded(theme.color.halo, alpha), 0, 0);
    ui::paint_dot(at, theme.scale * radius, color, 0, 0);
}

} // namespace

std::vector<gpu::Line> LatticePointsTool::lines(const Session& session,
                                                const ui::Theme& theme) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || !all_are_shown(laid->placement->volume)) return {};
    if (is_lattice(session.document(), laid->id)) return {}; // its net is shown anyway
    return shell_lines(laid->placement->volume, theme.color.lattice, theme.line(1),
                       {.edges = 0.26f});
}

void LatticePointsTool::paint_points(const Session& session, const ui::Theme& theme,
                                     const ViewportInput& input) const
{
    const Ref<Lattice> seen = cage(session);
    const Lattice& volume = *seen;
    std::vector<double> shares(volume.displacement.points.size());
    const auto share_of = [&](const glm::ivec3& p) -> double& {
        return shares[volume.displacement.index(p.x, p.y, p.z)];
    };
    for (const glm::ivec3& p : chosen_) share_of(p) = 1;
    if (gesture_ && proportional_.on && shown_.of == point_count(volume))
        for (std::size_t i = 0; i < shown_.weights.size(); ++i)
            share_of(shown_.points[i]) = shown_.weights[i];
    const double reach_px = all_are_shown(volume) ? std::numeric_limits<double>::infinity()
                                                  : shown_reach_px * input.scale;
    constexpr std::size_t many = 300; // more are a cloud that hides the model
    constexpr double near_px = 90;    // where they are handles all the same
    const double handles_px = shares.size() > many ? near_px * input.scale : reach_px;
    std::size_t shown = 0;
    each_point(volume, session.view.camera, [&](const glm::ivec3& p, glm::dvec2 at) {
        const auto share = static_cast<float>(share_of(p));
        const bool lit = hovered_ && *hovered_ == p;
        if (!lit && share <= 0 && glm::distance(at, input.mouse) > reach_px) return;
        if (!lit && ++shown > most_shown_points) return;
        const glm::vec2 at_window = input.rect.lo + glm::vec2(at);
        if (lit || share >= 1)
            return paint_point(theme, at_window, lit ? 5.5f : 4.5f, theme.color.selected);
        if (share <= 0 && glm::distance(at, input.mouse) > handles_px)
            return ui::paint_dot(at_window, 1.5f * theme.scale,
                                 ui::faded(theme.color.lattice, 0.6f), 0, 0);
        paint_point(theme, at_window, 3 + share,
                    on_shell(volume, p) || share > 0 ? theme.color.lattice
                                                     : ui::faded(theme.color.lattice, 0.45f));
        if (share > 0)
            ui::paint_dot(at_window, theme.scale * (3 + share),
                          ui::faded(theme.color.selected, share), 0, 0);
    });
}

void LatticePointsTool::paint_gesture(const Session& session, const ui::Theme& theme,
                                      const ViewportInput& input) const
{
    const Ref<Lattice> seen = cage(session);
    const Lattice& volume = *seen;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    if (proportional_.on) {
        const PicturePoint middle = project(session.view.camera, frame_of(volume).pivot);
        const double radius_px =
            proportional_.radius_m / pixel_size_world(session.view.camera, middle.depth_world);
        constexpr double most_px = 20000; // beyond it is no circle in the picture
        if (middle.depth_world > 0 && radius_px < most_px)
            for (const auto& [color, wide] :
                 {std::pair(theme.color.halo, 3.0f), {theme.color.selected, 1.4f}})
                ui::paint_dot(input.rect.lo + glm::vec2(middle.p_px), static_cast<float>(radius_px),
                              0, color, wide * theme.scale);
    }
    const Shaping* step = session.proposing() ? last_shaping(session, object_) : nullptr;
    if (!step) return;
    const bool short_of = step->would_fold;
    std::string words = kind_ == MotionKind::move ? amount_words(step->done) : gesture_->amount();
    if (proportional_.on) words += "  ·  radius " + ui::short_number(proportional_.radius_m) + " m";
    ui::paint_chip(
        theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
        {words + (short_of ? ", would fold" : ""), short_of ? theme.color.bad : ui::Color{0}});
}

void LatticePointsTool::overlay(const Session& session, const ui::Theme& theme,
                                const ViewportInput& input) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) return; // it was selected after the points were looked at
    paint_points(session, theme, input);
    if (box_px_ && glm::distance(*box_px_, input.mouse) >= click_slip_px)
        paint_choice_box(theme, input, *box_px_);
    if (chosen_.empty() || box_px_) return;
    paint_gizmo(theme, input.rect.lo,
                gizmo_shapes(gesture_ ? kind_ : MotionKind::move, session.view.camera,
                             frame_of(*cage(session)), input.scale),
                gesture_ ? gesture_->constraint() : hovered_handle_);
    if (gesture_) paint_gesture(session, theme, input);
}

} // namespace trivar
