// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/view.h"
#include "core/spline/surface.h"

#include <vector>

namespace trivar {

// Where a contact surface lies in the picture: from a pixel position to the parameters seen there.
// The surface is cut into steps x steps quads, which a grid of buckets finds.
class StripIndex {
public:
    StripIndex(const Surface<glm::dvec3>& surface, const View& view, glm::ivec2 steps);

    // How far the surface may sag behind the corners of the quads near the pixel, metres.
    double sag(glm::dvec2 p_px) const { return may_cover(p_px) ? sag_[bucket(p_px)] : 0; }

    // False where the strip certainly is not. A few nanoseconds.
    bool may_cover(glm::dvec2 p_px) const;

    // Parameters near which the strip is seen at the pixel; several where it crosses itself.
    std::vector<glm::dvec2> find(glm::dvec2 p_px) const;

    // The rectangle around the strip, and the typical size of a quad, pixels.
    glm::dvec2 lo_px() const { return lo_; }
    glm::dvec2 hi_px() const { return hi_; }
    double quad_px() const { return quad_px_; }

private:
    std::size_t bucket(glm::dvec2 p_px) const;
    glm::ivec2 steps_;
    std::vector<glm::dvec2> corners_px_; // (steps.x + 1) x (steps.y + 1)
    glm::dvec2 lo_, hi_;
    double quad_px_ = 1;
    glm::ivec2 buckets_{1};
    glm::dvec2 buckets_per_px_{1};
    std::vector<int> begin_, quads_; // of each bucket
    std::vector<double> sag_;        // the largest of each bucket
};

// For (rows x columns) points of a surface: how far it may sag away from the viewer between each
// point and its neighbours, estimated from second differences along the line of sight; metres.
std::vector<double> sags(const std::vector<glm::dvec3>& points, int rows, int columns,
                         const View& view);

} // namespace trivar
