// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/tools/tetrahedra/tetrahedra_points.h"
#include "editor/tools/tetrahedra/tetrahedron_glyph.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

std::vector<float> TetrahedraPoints::shares() const
{
    const double radius = pull_.radius;
    std::vector<float> out;
    for (const ControlPlace& place : places_) {
        double share = 0;
        for (const glm::dvec3& ball : middles(alone_))
            share = std::max(share, decay(ball_.decay, glm::distance(ball, place.rest) / radius));
        out.push_back(static_cast<float>(share));
    }
    return out;
}

void TetrahedraPoints::paint_point(const ui::Theme& theme, int point, const Paint& how) const
{
    // A share of the distance of neighbours, and pixels at scale 1.
    constexpr double glyph_share = 0.28, least_px = 5.5, most_px = 10;
    const TetrahedronGlyph glyph;
    const double scale = theme.scale, spacing = places_[static_cast<std::size_t>(point)].spacing;
    const double px =
        glyph_share * spacing * how.pixels_per_metre * glm::length(glm::dvec3(to_world_[0]));
    const auto radius = static_cast<float>(std::clamp(px, least_px * scale, most_px * scale));
    if (how.lit || how.share >= 1)
        return glyph.paint(theme, how.at, radius * (how.lit ? 1.45f : 1.2f), theme.color.selected);
    glyph.paint(theme, how.at, radius, theme.color.lattice);
    if (how.share > 0)
        glyph.paint(theme, how.at, radius, ui::faded(theme.color.selected, how.share));
}

void TetrahedraPoints::paint_motion(const Session& session, const ui::Theme& theme,
                                    const ViewportInput& input) const
{
    const TetrahedraOutcome* outcome =
        session.proposing() ? last_outcome(session, object_) : nullptr;
    if (!outcome) return;
    std::string words = gesture_->amount();
    if (proportional_) words += "  ·  radius " + ui::short_number(radius(session)) + " m";
    if (outcome->share < 1)
        words += fmt::format(", held at {}: it would fold", percent_text(outcome->share));
    paint_words(theme, input, words, outcome->share < 1);
}

} // namespace trivar
