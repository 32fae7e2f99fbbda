// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/depth_jump.h"
#include "core/placement/ray_grid.h"
#include "core/placement/view.h"
#include "core/rays/ray_scene.h"

#include <optional>
#include <vector>

namespace trivar {

// DepthJumps leaves out of a stroke the surfaces seen beyond the edges of the one that it lies on.
// A jump is `least` metres deep or more along the sight. A steep surface is none: rays in ever
// shorter steps tell them apart. Cost: a few rays for each step that may be one.
class DepthJumps {
public:
    DepthJumps(const Camera& camera, const RayScene& scene, bool skip_back_faces)
        : view_(camera),
          scene_(scene),
          skip_back_faces_(skip_back_faces)
    {
    }

    // Moves the nodes beyond an edge to where the surface would go on straight, and returns them.
    //   line       the middle line
    //   points_px  its points in the picture
    // Nothing: it ends on another surface than it began on, which is so little higher or lower that
    // it is to be followed. Throws Rejected, saying where, if that surface is far off.
    std::optional<std::vector<std::size_t>> bridge(RayGrid& line,
                                                   const std::vector<glm::dvec2>& points_px);
    // Bridges the jumps of a grid over that middle line.
    std::vector<std::size_t> bridge(RayGrid& grid, const Strip& strip, const RayGrid& line);

    const std::vector<DepthJump>& found() const { return found_; } // in the last line and grid

private:
    struct Seen {
        glm::dvec2 p_px;
        double distance;
        std::size_t node;
        bool beyond = false; // an edge
    };
    static std::vector<std::size_t> taken(RayGrid& grid, const std::vector<Seen>& line);
    bool jumps(Seen a, Seen b, double least) const;
    // Follows the surface from the first place; returns the places and depths of the jumps.
    std::vector<std::pair<std::size_t, double>> follow(std::vector<Seen>& line, double least) const;

    const View view_;
    const RayScene& scene_;
    bool skip_back_faces_;
    double least_ = 0;
    std::vector<DepthJump> found_; // those of the line first
    std::size_t of_line_ = 0;      // so many
};

} // namespace trivar
