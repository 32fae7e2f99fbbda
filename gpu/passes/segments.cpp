// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/segments.h"

#include "core/base/finite.h"
#include "core/base/mean_scale.h"

#include <algorithm>
#include <cmath>

namespace trivar::gpu {
namespace {

constexpr std::uint32_t as_ink_bit = 16; // line.vert

struct PathPoint {
    glm::vec3 p; // scene
    glm::vec4 color;
    float width = 1; // share
    float share = 0; // of the line's length that lies before it
};
using Path = std::vector<PathPoint>; // no two in a row at one place

// More than one where points between are nowhere.
std::vector<Path> paths_of(const Polyline& line, const glm::dmat4& to_scene)
{
    std::vector<Path> paths(1);
    double length = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const glm::vec3 p(to_scene * glm::dvec4(line.points[i], 1));
        Path& path = paths.back();
        if (!finite(p)) {
            if (!path.empty()) paths.emplace_back();
            continue;
        }
        if (!path.empty() && path.back().p == p) continue;
        if (!path.empty()) length += glm::distance(path.back().p, p);
        const glm::vec4 color = line.colors.empty()      ? glm::vec4(1)
                                : i < line.colors.size() ? line.colors[i]
                                                         : line.colors.back();
        const float width = i < line.widths.size() ? line.widths[i] : 1;
        path.push_back({p, color, width, static_cast<float>(length)});
    }
    if (length > 0)
        for (Path& path : paths)
            for (PathPoint& point : path) point.share /= static_cast<float>(length);
    return paths;
}

glm::vec2 on_screen(const Frame& frame, const glm::vec3& p)
{
    const glm::vec4 c = frame.view_clip * glm::vec4(p, 1);
    return glm::vec2(c) / std::max(c.w, 1e-4f) * glm::vec2(frame.size_px) * 0.5f;
}

// Arc lengths stay small: what is left out is a whole number of dashes, also of those of hidden
// parts.
float wrapped(float arc_px, float dash_px)
{
    return std::fmod(arc_px, dash_px > 0 ? 2000 * dash_px : 7000.0f);
}

} // namespace

void Segments::add(const Line& line)
{
    add({.points = line.points, .colors = {line.color}}, glm::dmat4(1), {.width_px = line.width_px},
        0);
}

void Segments::add(const Curve& curve)
{
    if (curve.line) add(*curve.line, curve.to_world, curve.style, curve.id);
}

void Segments::add(const Polyline& line, const glm::dmat4& to_world, const CurveStyle& style,
                   int id)
{
    if (line.points.size() > most_segments - all_.size()) {
        ++left_out_;
        return;
    }
    glm::dmat4 to_scene = to_world;
    to_scene[3] -= glm::dvec4(origin_world_, 0);
    const bool in_world = style.width_world > 0;
    const float size = static_cast<float>(mean_scale(to_world));
    Segment segment{};
    segment.width_taper = {in_world ? 0 : style.width_px * scale_,
                           in_world ? style.width_world * size : 0, style.taper};
    segment.id = id == 0 ? 0 : static_cast<std::uint32_t>(id) | curve_id_bit;
    segment.hidden = static_cast<std::uint32_t>(style.hidden) | (style.as_ink ? as_ink_bit : 0);
    segment.dash_px = style.dash_px * scale_;
    segment.own_reach = style.own_reach_world;
    for (const Path& path : paths_of(line, to_scene)) {
        if (path.empty()) continue;
        const std::size_t last = path.size() - 1;
        const bool closed = last > 2 && path[0].p == path[last].p;
        float arc_px = 0;
        for (std::size_t i = 0; i < std::max<std::size_t>(last, 1); ++i) {
            const std::size_t next = std::min(i + 1, last); // a single point is a dot
            segment.from = path[i].p;
            segment.to = path[next].p;
            segment.before = i > 0 ? path[i - 1].p : closed ? path[last - 1].p : segment.from;
            segment.after = next < last ? path[next + 1].p : closed ? path[1].p : segment.to;
            segment.color_from = path[i].color;
            segment.color_to = path[next].color;
            segment.width_shares = {path[i].width, path[next].width};
            const float length =
                glm::distance(on_screen(frame_, segment.from), on_screen(frame_, segment.to));
            const float step_px = std::isfinite(length) ? std::min(length, 1e5f) : 0;
            segment.along = {arc_px, arc_px + step_px, path[i].share, path[next].share};
            all_.push_back(segment);
            arc_px = wrapped(arc_px + step_px, segment.dash_px);
        }
    }
}

} // namespace trivar::gpu
