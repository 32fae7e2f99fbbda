// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A StrokePoint is a point of a line drawing. Places are in pixels, x to the right, y down.
struct StrokePoint {
    glm::vec2 at{0};
    float depth = 0;    // away from the eye, 0 .. 1 between the planes of the view
    float slope = 0;    // |grad D|, per voxel
    float bend = 0;     // of the silhouette along the line of sight, per voxel
    glm::vec3 p{0};     // voxels
    float strength = 1; // 0 .. 1, see SilhouettePoint
};

// A Stroke is one line of a drawing, all of it seen or all of it hidden.
struct Stroke {
    std::vector<StrokePoint> points; // of a loop, the first again at the end
    bool hidden = false;
    bool tapers_first = true, tapers_last = true; // where the end has no line that goes on
    std::uint64_t id = 0; // the least edge of its points, or as LineIds gave it
    double length() const // pixels
    {
        double out = 0;
        for (std::size_t i = 1; i < points.size(); ++i)
            out += glm::distance(points[i - 1].at, points[i].at);
        return out;
    }
    bool is_loop() const { return points.size() > 3 && points.front().at == points.back().at; }
};

struct StrokeOptions {
    float join = 6;       // pixels between ends that face each other and become one stroke
    float shortest = 8;   // pixels; shorter ones are left out, after they were joined
    float spacing = 1.5f; // pixels between points of the smooth strokes
};

} // namespace trivar
