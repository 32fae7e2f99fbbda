// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/fibre_clipping.h"

namespace trivar {

// K planes cut the simplex { mu >= 0, sum mu <= 1 } into simplices, one plane after the other. All
// that is computed is continuous in l and B, so nothing depends on how a sign is rounded. [1]
// calls this the fibre over a point of a simplex that is projected. l must sum to 1, and so must
// the columns of B; then sum mu <= 1 follows. About 30, 60, 300 ns for N = 1, 2, 3.
//   [1] Micchelli, On a numerically efficient method for computing multivariate B-splines, 1979
template <int N, int K>
FibreVolume<K> fibre_volume(const std::array<double, K>& l,
                            const std::array<glm::vec<N, double>, K>& rows, bool facets)
{
    fibre_detail::Clipping<N, K> clipping(l, rows, facets);
    clipping.whole();
    return clipping.out;
}

} // namespace trivar
