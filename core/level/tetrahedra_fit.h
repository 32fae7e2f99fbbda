// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// A TetrahedraFit says how volume data are fitted by a spline over tetrahedra that follow a
// boundary in them, across which it may jump.
struct TetrahedraFit {
    int coefficients = 0; // at most so many, 100 to 30,000; 0: there is no fit
    int degree = 2;       // 1..3
    double boundary = 0;  // value of the data there
    bool operator==(const TetrahedraFit&) const = default;
};

} // namespace trivar
