// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/camera.h"
#include "core/voxels/voxel_grid.h"

#include <vector>

namespace trivar {

// The unit direction of three numbers that an option has. Throws WrongUsage.
glm::dvec3 direction_of(const std::vector<double>& numbers, const char* option);

// The samples that are at least a level, or else those that are less.
struct SampleBody {
    double level = 0;
    bool above = true;
};

// A SilhouetteAim says how a drawing looks at a volume, by directions in the volume's own space.
struct SilhouetteAim {
    std::vector<double> view, up; // up: none: Z, or Y where one looks along Z
    double fov_deg = 0;           // 0: parallel
    glm::ivec2 size_px{1};
    bool whole_grid = false; // is framed, whatever is drawn
};

// A SilhouetteView finds the camera of a drawing: it looks at the bodies whose samples it was
// shown, or at the whole grid where there are none.
class SilhouetteView {
public:
    // Throws WrongUsage for directions that are none.
    SilhouetteView(SilhouetteAim aim, const glm::dmat4& to_metres, const glm::ivec3& size);
    // Takes in a slice of the grid, whose samples begin at a number.
    void see(const VoxelGrid::Samples& samples, std::size_t first, int z, const SampleBody& body);
    Camera camera() const;

private:
    glm::dvec3 place(const glm::dvec3& voxel) const; // across, upward and along, metres
    SilhouetteAim aim_;
    glm::dmat4 to_metres_;
    glm::ivec3 size_;
    Camera camera_; // with its up, and the middle of the grid as its target
    glm::dmat3 to_space_{1};
    Box seen_; // around that middle
};

} // namespace trivar
