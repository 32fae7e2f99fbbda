// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/field_spline.h"
#include "core/field/row4.h"
#include "core/field/scalar_jet.h"
#include "core/field/spline_weights.h"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A ScalarField is a trivariate B-spline function over a grid of samples. Sample (i, j, k) is at
// the point (i, j, k): places are in voxels throughout. Beyond the first and the last sample the
// samples are mirrored, which is as if they went on with slope 0.
template <class Real> class ScalarField {
public:
    // Builds the coefficients by a causal and an anticausal recursion along each axis [Unser,
    // Aldroubi, Eden 1993].
    //   samples  x fastest
    //   size     number of samples along each axis, at least 2
    //   spline   interpolating goes through the samples, smoothing takes them as coefficients
    // Cost: 4 bytes a sample (8 for double), 0.2 ns a byte. Throws Rejected if the size does not
    // fit the number of samples or an axis has fewer than two.
    template <class Sample>
    ScalarField(std::span<const Sample> samples, const glm::ivec3& size,
                FieldSpline spline = FieldSpline::interpolating,
                FieldOrder order = FieldOrder::cubic);

    // Builds the function near a slab of the grid, at the places of the whole grid.
    //   samples      those of all slices from `first_slice` on that are held
    //   size         of the whole grid
    // Samples beyond the slab are taken as mirrored, which is wrong except at the ends of the grid:
    // n slices within the slab a value errs by a share of 0.27^n, below the rounding from 16 on.
    template <class Sample>
    ScalarField(std::span<const Sample> samples, const glm::ivec3& size, int first_slice,
                FieldSpline spline, FieldOrder order);

    // Returns the same function over a part of the grid. Its place p is the place first + p of this
    // one, and it has the same values there, also in its border.
    //   first  the first sample of the part
    //   size   number of its samples along each axis, at least 2
    // O(#samples of the part).
    ScalarField part(const glm::ivec3& first, const glm::ivec3& size) const;

    const glm::ivec3& size() const { return size_; } // number of samples along each axis
    // The slices of samples that it holds: all of them, but for a slab.
    int first_slice() const { return first_slice_; }
    int slice_count() const { return slices_; }
    FieldOrder order() const { return order_; }
    FieldSpline spline() const { return spline_; }
    // The greatest coordinates of the grid.
    glm::vec3 end() const { return glm::vec3(size_ - 1); }

    // The value, or with the gradient, or with both and the Hessian, by the number of derivatives.
    // Beyond the grid the polynomial of its outermost cell goes on. 30 to 50 ns.
    template <int derivatives> ScalarJet<Real> at(Real x, Real y, Real z) const;
    template <int derivatives> ScalarJet<Real> at(const glm::vec<3, Real>& p) const
    {
        return at<derivatives>(p.x, p.y, p.z);
    }

    // The coefficient number (i, j, k), from -1 to the number of samples along each axis; of a slab
    // from one slice before it to one behind it.
    const Real& coefficient(int i, int j, int k) const { return coefficients_[index(i, j, k)]; }
    std::size_t row() const { return row_; }     // from one j to the next
    std::size_t plane() const { return plane_; } // from one k to the next
    std::size_t bytes() const { return coefficients_.size() * sizeof(Real); }

private:
    std::size_t index(int i, int j, int k) const
    {
        return static_cast<std::size_t>(i + 1) + row_ * static_cast<std::size_t>(j + 1) +
               plane_ * static_cast<std::size_t>(k - first_slice_ + 1);
    }
    struct Slab {
        int first, count;
    };
    ScalarField(const glm::ivec3& size, Slab slab, FieldSpline spline, FieldOrder order); // all 0
    template <class Sample> void take(std::span<const Sample> samples);
    void filter_along_x(int k);
    void filter_lines(Real* first, std::size_t stride, int count, std::size_t width) const;
    void mirror_border(int k);

    glm::ivec3 size_;
    int first_slice_, slices_;
    FieldSpline spline_;
    FieldOrder order_;
    std::size_t row_ = 0, plane_ = 0;
    std::vector<Real> coefficients_;
};

template <class Real>
template <int derivatives>
ScalarJet<Real> ScalarField<Real>::at(Real x, Real y, Real z) const
{
    using Row = Row4<Real>;
    const SplineWeights<Real> u = spline_weights(order_, x, size_.x),
                              v = spline_weights(order_, y, size_.y),
                              w = spline_weights(order_, z, size_.z);
    const Real* p = coefficients_.data() + index(u.first, v.first, w.first);
    Row sum{}, by_y{}, by_z{}, by_yy{}, by_zz{}, by_yz{};
    for (std::size_t b = 0; b < 4; ++b, p += row_) {
        const Row c0 = row4(p), c1 = row4(p + plane_), c2 = row4(p + 2 * plane_),
                  c3 = row4(p + 3 * plane_);
        const auto along_z = [&](const std::array<Real, 4>& k) {
            return k[0] * c0 + k[1] * c1 + k[2] * c2 + k[3] * c3;
        };
        const Row value = along_z(w.value);
        sum += v.value[b] * value;
        if constexpr (derivatives >= 1) {
            const Row slope = along_z(w.slope);
            by_y += v.slope[b] * value;
            by_z += v.value[b] * slope;
            if constexpr (derivatives >= 2) {
                by_yz += v.slope[b] * slope;
                by_yy += v.bend[b] * value;
                by_zz += v.value[b] * along_z(w.bend);
            }
        }
    }
    const Row value = row4(u.value.data()), slope = row4(u.slope.data()),
              bend = row4(u.bend.data());
    ScalarJet<Real> out;
    if constexpr (derivatives == 0) out.value = dot(sum, value);
    if constexpr (derivatives >= 1) {
        const Row first = four_sums(sum * value, sum * slope, by_y * value, by_z * value);
        out.value = first[0];
        out.gradient = {first[1], first[2], first[3]};
    }
    if constexpr (derivatives >= 2) {
        const Row second = four_sums(sum * bend, by_yy * value, by_zz * value, by_y * slope);
        out.hessian = {second[0], second[1],        second[2],
                       second[3], dot(by_z, slope), dot(by_yz, value)};
    }
    return out;
}

} // namespace trivar
