// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/lattice_points.h"

#include "editor/hands/helpers.h"
#include "editor/hands/last_shaping.h"
#include "editor/hands/point_choice.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/viewport_input.h"
#include "editor/picture/volume_picture.h"
#include "ui/widgets.h"

namespace trivar {
namespace {

// Inner points are fainter, so that the box reads as one.
bool on_shell(const glm::ivec3& count, const glm::ivec3& p)
{
    const glm::ivec3 last = count - 1;
    return glm::any(glm::equal(p, glm::ivec3(0))) || glm::any(glm::equal(p, last));
}

// A dot on a dark one, so that it stands out on any ground.
void paint_haloed_dot(const ui::Theme& theme, glm::vec2 at, float radius, ui::Color color)
{
    const float alpha = static_cast<float>(color >> 24) / 255;
    ui::paint_dot(at, theme.scale * (radius + 1.25f), ui::faded(theme.color.halo, alpha), 0, 0);
    ui::paint_dot(at, theme.scale * radius, color, 0, 0);
}

} // namespace

Helpers LatticePointsTool::helpers(const Session& session, const ui::Theme& theme) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->placement->volume.displacement.points.size() > most_shown_points) return {};
    if (is_lattice(session.document(), laid->id)) return {}; // its net is shown anyway
    return {.lines = shell_lines(laid->placement->volume, theme.color.lattice, theme.line(1),
                                 {.edges = 0.26f})};
}

std::vector<float> LatticePointsTool::shares() const
{
    std::vector<float> out(at_world_.size());
    for (std::size_t i = 0; i < shown_.weights.size() && shown_.of == of_; ++i)
        out[static_cast<std::size_t>(number_of(shown_.points[i], of_))] =
            static_cast<float>(shown_.weights[i]);
    return out;
}

void LatticePointsTool::paint_point(const ui::Theme& theme, int point, const Paint& how) const
{
    const ui::Palette& c = theme.color;
    if (how.lit || how.share >= 1)
        return paint_haloed_dot(theme, how.at, how.lit ? 5.5f : 4.5f, c.selected);
    const bool plain = on_shell(of_, point_of(point, of_)) || how.share > 0;
    paint_haloed_dot(theme, how.at, 3 + how.share, plain ? c.lattice : ui::faded(c.lattice, 0.45f));
    if (how.share > 0)
        ui::paint_dot(how.at, theme.scale * (3 + how.share), ui::faded(c.selected, how.share), 0,
                      0);
}

void LatticePointsTool::paint_motion(const Session& session, const ui::Theme& theme,
                                     const ViewportInput& input) const
{
    if (proportional_) {
        const PicturePoint middle = project(session.view.camera, frame(session).pivot);
        const double radius_px =
            radius_m_ / pixel_size_world(session.view.camera, middle.depth_world);
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
    std::string words =
        gesture_->kind() == MotionKind::move ? amount_words(step->done) : gesture_->amount();
    if (proportional_) words += "  ·  radius " + ui::short_number(radius_m_) + " m";
    paint_words(theme, input, words + (short_of ? ", would fold" : ""), short_of);
}

} // namespace trivar
