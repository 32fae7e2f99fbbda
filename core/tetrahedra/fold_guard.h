// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_rows.h"
#include "core/simplex/simplex_volume.h"

namespace trivar {

// A FoldGuard knows the derivative of a volume at samples: five in each cell of each layer up to
// 20,000 cells; above, the middle of each or, with more than 100,000, of every second, third ...
// one. Between them nothing is proven.
class FoldGuard {
public:
    // O(number of cells).
    explicit FoldGuard(std::span<const Ref<SimplexBasis<3>>> layers);

    // The greatest share, 0..1, of a change of displacements of which no lesser share takes det J
    // below 0.02 at a sample. Samples that are below it before do not count.
    double allowed(std::span<const glm::dvec3> displacements,
                   std::span<const glm::dvec3> change) const;
    // The least det J at all samples.
    double least(std::span<const glm::dvec3> displacements) const;
    std::size_t sample_count() const { return rows_.point_count(); }

private:
    SimplexRows rows_;
};

} // namespace trivar
