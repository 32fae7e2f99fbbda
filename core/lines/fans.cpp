// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/fans.h"

#include "core/field/value_range.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

constexpr int hairs = 5;
constexpr double narrow_deg = 14, wide_deg = 110; // from the first to the last hair
constexpr float shortest_hair = 0.45f;            // share of the length
constexpr float hair_width = 0.45f;               // share of the width of a line

// A place in the image with the depth of a point, in voxels.
glm::vec3 in_space(const glm::dmat4& to_voxels, const glm::dvec2& at, double depth)
{
    const glm::dvec4 p = to_voxels * glm::dvec4(at, depth, 1);
    return glm::vec3(glm::dvec3(p) / p.w);
}

glm::dvec3 in_picture(const glm::dmat4& to_image, const glm::dvec3& p)
{
    const glm::dvec4 q = to_image * glm::dvec4(p, 1);
    return glm::dvec3(q) / q.w;
}

} // namespace

std::vector<InkedLine> fans(const LevelBody& body, std::span<const Stroke> strokes,
                            const LineStyle& style, const glm::dmat4& to_image)
{
    std::vector<InkedLine> out;
    if (!(style.fan_step > 0)) return out;
    std::vector<float> slopes;
    for (const Stroke& stroke : strokes)
        if (!stroke.hidden)
            for (const StrokePoint& p : stroke.points) slopes.push_back(p.slope);
    const ValueRange range(std::move(slopes));
    const glm::dmat4 to_voxels = glm::inverse(to_image);
    const double outward = body.side == LevelSide::above ? -1 : 1; // along the gradient
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        const Stroke& stroke = strokes[s];
        if (stroke.hidden) continue;
        double way = 0, next = double{style.fan_step} / 2;
        for (std::size_t i = 1; i < stroke.points.size(); ++i) {
            const StrokePoint& p = stroke.points[i];
            way += double{glm::distance(p.at, stroke.points[i - 1].at)};
            if (way < next) continue;
            next += double{style.fan_step};
            const glm::dvec3 n(gradient_of(body.field.at<1>(p.p)));
            const glm::dvec3 base = in_picture(to_image, glm::dvec3(p.p));
            const double norm = glm::length(n);
            if (!(norm > 0)) continue;
            const glm::dvec2 away(
                glm::dvec2(in_picture(to_image, glm::dvec3(p.p) + outward / norm * n) - base));
            if (!(glm::length(away) > 0)) continue;
            const glm::dvec2 middle = glm::normalize(away);
            const double steep = double{range.share(p.slope)};
            const double length =
                double{style.fan_length} * std::lerp(double{shortest_hair}, 1.0, steep);
            const double open = glm::radians(std::lerp(wide_deg, narrow_deg, steep));
            InkedLine fan;
            fan.id = stroke.id;
            fan.stroke = s;
            const auto add = [&](const glm::dvec2& at, float width) {
                fan.points.push_back(
                    {glm::vec2(at), width, style.color, in_space(to_voxels, at, base.z)});
            };
            const float width = hair_width * style.width;
            for (int k = 0; k < hairs; ++k) {
                const double turn = open * (static_cast<double>(k) / (hairs - 1) - 0.5);
                const glm::dvec2 way_out(middle.x * std::cos(turn) - middle.y * std::sin(turn),
                                         middle.x * std::sin(turn) + middle.y * std::cos(turn));
                add(glm::dvec2(base), width);
                add(glm::dvec2(base) + length * way_out, width);
            }
            out.push_back(std::move(fan));
        }
    }
    return out;
}

std::vector<InkedLine> inked_with_fans(const LevelBody& body, std::span<const Stroke> strokes,
                                       const LineStyle& style, const glm::dmat4& to_image)
{
    std::vector<InkedLine> out = inked(strokes, style);
    for (InkedLine& fan : fans(body, strokes, style, to_image)) out.push_back(std::move(fan));
    return out;
}

} // namespace trivar
