// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/scalar_field.h"

namespace trivar {

// FieldHulls bounds a field in bricks of 4 x 4 x 4 cells by the least and the greatest of the
// coefficients there: a spline stays in the hull of its coefficients. Of a slab it has the bricks
// of its slices, of which those at both ends may know too little. 1/8 byte per sample.
class FieldHulls {
public:
    static constexpr int brick = 4; // cells along each axis

    explicit FieldHulls(const ScalarField<float>& field);

    struct Range {
        float least, greatest;
    };
    // The brick of a place in voxels; a place beyond the grid has the nearest one.
    glm::ivec3 brick_of(const glm::vec3& p) const
    {
        return glm::clamp(glm::ivec3(p) / brick, glm::ivec3(0), bricks_ - 1);
    }
    const Range& of(const glm::ivec3& b) const
    {
        return ranges_[static_cast<std::size_t>(b.x) +
                       static_cast<std::size_t>(bricks_.x) *
                           (static_cast<std::size_t>(b.y) +
                            static_cast<std::size_t>(bricks_.y) *
                                static_cast<std::size_t>(b.z - first_layer_))];
    }
    const glm::ivec3& bricks() const { return bricks_; } // number along each axis
    Range whole() const;                                 // of all bricks
    std::size_t bytes() const { return ranges_.size() * sizeof(Range); }

private:
    glm::ivec3 bricks_;
    int first_layer_;           // of bricks, along z
    std::vector<Range> ranges_; // x fastest
};

} // namespace trivar
