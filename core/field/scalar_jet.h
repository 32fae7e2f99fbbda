// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// A ScalarJet is a value of a field with its derivatives, per voxel and per voxel squared.
template <class Real> struct ScalarJet {
    Real value = 0;
    std::array<Real, 3> gradient{};
    std::array<Real, 6> hessian{}; // xx yy zz xy xz yz
};

template <class Real> glm::vec<3, Real> gradient_of(const ScalarJet<Real>& jet)
{
    return {jet.gradient[0], jet.gradient[1], jet.gradient[2]};
}

template <class Real> glm::mat<3, 3, Real> hessian_of(const ScalarJet<Real>& jet)
{
    const auto& h = jet.hessian;
    return {h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2]};
}

} // namespace trivar
