// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/scalar_field.h"
#include "core/silhouette/silhouettes.h"

#include <span>

namespace trivar {

// Moves a place to D = level and <V, grad D> = 0, by Newton steps of least norm (two equations,
// three unknowns).
//   p          voxels; of no use if it fails
//   jet        receives the field's jet at the last step but one
//   tolerance  voxels
// Returns false if the two surfaces touch, or the place is more than a voxel away or beyond the
// grid.
template <class Real>
bool polish(const ScalarField<Real>& field, Real level, const ViewPoint& view, glm::vec<3, Real>& p,
            ScalarJet<Real>& jet, Real tolerance = Real(1e-4));

// Polishes points if `polished`, eight at once, and sets their other values. 0.2 us per point on
// one core.
void finish(const ScalarField<float>& field, float level, const ViewPoint& view, bool polished,
            std::span<SilhouettePoint> points);

} // namespace trivar
