// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/silhouette/silhouette_finder.h"
#include "tests/field/fields.h"

namespace trivar::testing {

// A sampled function with its field.
struct Sampled {
    Sampled(const std::string& function, int n)
        : from(sampled(function, n)),
          samples(in_single_precision(from.samples)),
          field(std::span<const float>(samples), from.size)
    {
    }
    LevelMesh level(double at) const
    {
        return level_mesh(field, std::span<const float>(samples), static_cast<float>(at));
    }
    LevelMesh level() const { return level(from.level); }

    SampledField from;
    std::vector<float> samples;
    ScalarField<float> field;
};

// Random views of a grid; every second one is from an eye.
std::vector<ViewPoint> some_views(const glm::ivec3& size, int count);
// Maps voxels to an image with 4 pixels per voxel, seen in parallel, with the depth growing along
// the direction of sight.
glm::dmat4 image_of(const glm::dvec3& sight);

} // namespace trivar::testing
