// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace trivar {

// A ScalarJet is a value of a field with its derivatives, per voxel and per voxel squared.
template <class Real> struct ScalarJet {
    Real value = 0;
    std::array<Real, 3> gradient{};
    std::array<Real, 6> hessian{}; // xx yy zz xy xz yz
};

} // namespace trivar
