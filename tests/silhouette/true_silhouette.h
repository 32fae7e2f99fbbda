// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/scalar_field.h"
#include "core/silhouette/silhouettes.h"

namespace trivar::testing {

// Places of a silhouette that an exhaustive search finds in double precision: Newton's method from
// the middle of every eighth of a voxel, kept where it stays in it.
std::vector<glm::dvec3> true_silhouette(const ScalarField<double>& field, double level,
                                        const ViewPoint& view);

// The share of places that are within a distance of the curves.
double share_near(const std::vector<glm::dvec3>& places, const Silhouettes& curves,
                  double distance);

} // namespace trivar::testing
