// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/overlays.h"

#include "core/base/finite.h"

#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

struct Segment {
    glm::vec3 from, to;
    glm::vec4 color;
    glm::vec3 arc_width; // arc length at both ends, width; pixels
};

std::vector<Segment> segments_of(const std::vector<Line>& lines, const Frame& frame,
                                 const glm::dvec3& origin_world)
{
    const auto on_screen = [&](const glm::vec3& p) {
        const glm::vec4 c = frame.view_clip * glm::vec4(p, 1);
        return glm::vec2(c) / std::max(c.w, 1e-4f) * glm::vec2(frame.size_px) * 0.5f;
    };
    std::vector<Segment> out;
    for (const Line& line : lines) {
        float arc_px = 0;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            if (!finite(line.points[i]) || !finite(line.points[i + 1])) continue;
            const glm::vec3 from = glm::dvec3(line.points[i]) - origin_world;
            const glm::vec3 to = glm::dvec3(line.points[i + 1]) - origin_world;
            const float length = glm::distance(on_screen(from), on_screen(to));
            const float step_px = std::isfinite(length) ? std::min(length, 1e5f) : 0;
            out.push_back({from, to, line.color, {arc_px, arc_px + step_px, line.width_px}});
            arc_px = std::fmod(arc_px + step_px, 7000.0f); // a whole number of dashes
        }
    }
    return out;
}

} // namespace

LinePass::LinePass()
{
    segments_.write({});
    const int stride = sizeof(Segment);
    vertices_.attribute(0, segments_, 3, stride, offsetof(Segment, from), 1);
    vertices_.attribute(1, segments_, 3, stride, offsetof(Segment, to), 1);
    vertices_.attribute(2, segments_, 4, stride, offsetof(Segment, color), 1);
    vertices_.attribute(3, segments_, 3, stride, offsetof(Segment, arc_width), 1);
}

void LinePass::draw(Tools& tools, const Targets& targets, const Frame& frame,
                    const std::vector<Line>& lines, const glm::dvec3& origin_world)
{
    const std::vector<Segment> segments = segments_of(lines, frame, origin_world);
    if (segments.empty()) return;
    segments_.write(std::as_bytes(std::span(segments)));
    targets.to_encoded.bind();
    const Program& program = tools.use({"line", "line", {}});
    vertices_.bind();
    for (const bool hidden : {true, false}) {
        set_state({.depth = hidden ? DepthTest::greater : DepthTest::less_equal, .blend = true});
        program.set("width_factor", hidden ? 0.66f : 1.0f);
        program.set("opacity", hidden ? 0.55f : 1.0f);
        program.set("dash_px", hidden ? glm::vec2(7, 3.5f) : glm::vec2(0));
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments.size()));
    }
}

} // namespace trivar::gpu
