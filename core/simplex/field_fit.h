// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_field.h"

#include <span>

namespace trivar {

// A value at a place of the domain's space.
struct FieldSample {
    glm::dvec3 at;
    double value;
};

// A field with how well it fits.
struct FieldFit {
    SimplexField field;
    std::size_t coefficients = 0; // unknowns: control points that are shared count once
    std::size_t held = 0;         // of them, those under which there were too few samples
    std::size_t samples = 0;      // in the domain
    double rms = 0;               // of the differences at these
};

// Returns the number of unknowns of a fit on such a domain; see PointSharing::all. O(number of
// cells).
std::size_t fit_size(const SimplexDomain<3>& domain);

// Fits a field to samples by least squares; samples outside of the domain do not count. An unknown
// whose functions sum to less than 4 over all samples is held to the mean of these, or of its
// neighbours where there are none, by half a sample's weight at most. Polynomials of the degree are
// found again to 1e-9 if there are samples enough.
//
// Rows of the basis's values are summed to normal equations, cell by cell; these are solved by a
// sparse factorisation. Cost: 7 us per sample for degree 2 and 3 s for 10,000 unknowns. Throws
// Rejected if there are fewer samples in the domain than unknowns, for more than 30,000 unknowns
// and samples that are not finite. The same bits for any number of threads.
FieldFit fitted_field(const Ref<SimplexBasis<3>>& basis, std::span<const FieldSample> samples);

} // namespace trivar
