// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/hands/select.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/tools/tetrahedra/tetrahedra_points.h"
#include "editor/tools/tetrahedra/tetrahedron_glyph.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double glyph_share = 0.28, least_px = 5.5, most_px = 10; // of the distance of neighbours

struct Seen {
    std::size_t place;
    glm::dvec2 at_px;
    double depth;
};

} // namespace

void TetrahedraPoints::overlay(const Session& session, const ui::Theme& theme,
                               const ViewportInput& input, const Manner& manner) const
{
    const EvaluatedObject* volume = selected_tetrahedra(session);
    if (!volume || volume->id != object_) return;
    const Camera& camera = session.view.camera;
    std::vector<float> shares(places_.size(), 0);
    for (const int i : chosen_) shares[static_cast<std::size_t>(i)] = 1;
    if (gesture_ && manner.proportional)
        for (std::size_t i = 0; i < places_.size(); ++i)
            for (const glm::dvec3& ball : middles(alone_))
                shares[i] = std::max(
                    shares[i],
                    static_cast<float>(
                        decay(manner.decay, glm::distance(ball, places_[i].rest) / manner.radius)));
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < at_world_.size(); ++i)
        if (const PicturePoint p = project(camera, at_world_[i]); p.depth_world > 0)
            seen.push_back({i, p.p_px, p.depth_world});
    std::ranges::sort(seen, std::ranges::greater{}, &Seen::depth);
    const TetrahedronGlyph glyph;
    for (const Seen& each : seen) {
        const glm::vec2 at = input.rect.lo + glm::vec2(each.at_px);
        const float share = shares[each.place];
        const bool lit = hovered_ && static_cast<std::size_t>(*hovered_) == each.place;
        const bool near = glm::distance(each.at_px, input.mouse) < handles_near_px * input.scale;
        if (!lit && share <= 0 && places_.size() > many_handles && !near) {
            ui::paint_dot(at, 1.5f * theme.scale, ui::faded(theme.color.lattice, 0.6f), 0, 0);
            continue;
        }
        const double px = glyph_share * places_[each.place].spacing * length_of(*volume) /
                          pixel_size_world(camera, each.depth);
        const auto radius =
            static_cast<float>(std::clamp(px, least_px * input.scale, most_px * input.scale));
        if (lit || share >= 1)
            glyph.paint(theme, at, radius * (lit ? 1.45f : 1.2f), theme.color.selected);
        else {
            glyph.paint(theme, at, radius, theme.color.lattice);
            if (share > 0) glyph.paint(theme, at, radius, ui::faded(theme.color.selected, share));
        }
    }
    if (box_px_ && glm::distance(*box_px_, input.mouse) >= click_slip_px)
        paint_choice_box(theme, input, *box_px_);
    if (chosen_.empty() || box_px_) return;
    paint_gizmo(
        theme, input.rect.lo,
        gizmo_shapes(gesture_ ? kind_ : MotionKind::move, camera, frame(*volume), input.scale),
        gesture_ ? gesture_->constraint() : hovered_handle_);
    const TetrahedraOutcome* outcome =
        gesture_ && session.proposing() ? last_outcome(session, object_) : nullptr;
    if (!outcome) return;
    std::string words = gesture_->amount();
    if (manner.proportional) words += "  ·  radius " + ui::short_number(manner.radius) + " m";
    if (outcome->share < 1)
        words += fmt::format(", held at {}: it would fold", percent_text(outcome->share));
    ui::paint_chip(theme,
                   input.rect.lo + glm::vec2(input.mouse) + glm::vec2(theme.px(18), -theme.px(30)),
                   {words, outcome->share < 1 ? theme.color.bad : ui::Color{0}});
}

std::vector<Hint> TetrahedraPoints::hints() const
{
    if (gesture_) {
        std::vector<Hint> out = gesture_.hints("Along an axis");
        if (manner_.proportional) out.insert(out.begin() + 2, {{"wheel"}, "Radius"});
        return out;
    }
    std::vector<Hint> out{{{"left"}, chosen_.empty() ? "Select a point" : "Drag a point or handle"},
                          {{"Shift", "left"}, "Add or remove"},
                          {{"left"}, "Drag a box"},
                          {{"@Proportional editing"}, "Neighbours too"},
                          {{"Esc"}, "Select"}};
    if (!chosen_.empty())
        out.insert(out.begin() + 1, {{"@Move", "@Rotate", "@Scale"}, "With the mouse"});
    return out;
}

} // namespace trivar
