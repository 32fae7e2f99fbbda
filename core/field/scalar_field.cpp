// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/field/scalar_field.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"

#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr int lanes = 16;          // rows that are filtered side by side
constexpr int mirrored_terms = 28; // 0.268^28 is 1e-16

// A Prefilter is the recursion that gives the coefficients of an interpolating spline.
struct Prefilter {
    double pole, gain;
};

Prefilter prefilter_of(FieldOrder order)
{
    if (order == FieldOrder::cubic) return {std::sqrt(3.0) - 2, 6};
    return {2 * std::sqrt(2.0) - 3, 8};
}

// The sample that stands for number i of `count`, as the row is mirrored at its ends.
int mirrored(int i, int count)
{
    const int period = 2 * (count - 1);
    i %= period;
    return i < count ? i : period - i;
}

} // namespace

template <class Real>
ScalarField<Real>::ScalarField(const glm::ivec3& size, Slab slab, FieldSpline spline,
                               FieldOrder order)
    : size_(size),
      first_slice_(slab.first),
      slices_(slab.count),
      spline_(spline),
      order_(order)
{
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] < 2 || slab.count < 2)
            throw Rejected(fmt::format("a volume needs at least two samples along each axis; this "
                                       "one has {} x {} x {}",
                                       size.x, size.y, size.z));
    row_ = static_cast<std::size_t>(size.x) + 2;
    plane_ = row_ * (static_cast<std::size_t>(size.y) + 2);
    // Orders below 4 have weights of 0, whose coefficients may be one plane and row further on.
    const std::size_t beyond = order == FieldOrder::cubic ? 0 : 2 * (plane_ + row_ + 2);
    coefficients_.resize(plane_ * (static_cast<std::size_t>(slices_) + 2) + beyond);
}

template <class Real>
template <class Sample>
ScalarField<Real>::ScalarField(std::span<const Sample> samples, const glm::ivec3& size,
                               FieldSpline spline, FieldOrder order)
    : ScalarField(size, {0, size.z}, spline, order)
{
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              static_cast<std::size_t>(size.z);
    if (samples.size() != count)
        throw Rejected(
            fmt::format("{} samples are not {} x {} x {}", samples.size(), size.x, size.y, size.z));
    take(samples);
}

template <class Real>
template <class Sample>
ScalarField<Real>::ScalarField(std::span<const Sample> samples, const glm::ivec3& size,
                               int first_slice, FieldSpline spline, FieldOrder order)
    : ScalarField(
          size,
          {first_slice, static_cast<int>(samples.size() / (static_cast<std::size_t>(size.x) *
                                                           static_cast<std::size_t>(size.y)))},
          spline, order)
{
    take(samples);
}

template <class Real>
ScalarField<Real> ScalarField<Real>::part(const glm::ivec3& first, const glm::ivec3& size) const
{
    ScalarField out(size, {0, size.z}, spline_, order_);
    parallel_blocks(static_cast<std::size_t>(size.z) + 2, 1, [&](std::size_t plane, std::size_t) {
        const int k = static_cast<int>(plane) - 1;
        for (int j = -1; j <= size.y; ++j)
            std::copy_n(coefficients_.data() + index(first.x - 1, first.y + j, first.z + k),
                        out.row_, out.coefficients_.data() + out.index(-1, j, k));
    });
    return out;
}

template <class Real>
template <class Sample>
void ScalarField<Real>::take(std::span<const Sample> samples)
{
    const bool filtered = spline_ == FieldSpline::interpolating && order_ != FieldOrder::linear;
    const double gain = filtered ? std::pow(prefilter_of(order_).gain, 3) : 1;
    const auto width = static_cast<std::size_t>(size_.x),
               height = static_cast<std::size_t>(size_.y),
               depth = static_cast<std::size_t>(slices_);
    parallel_blocks(depth, 1, [&](std::size_t k, std::size_t) {
        const int z = first_slice_ + static_cast<int>(k);
        for (std::size_t j = 0; j < height; ++j) {
            const Sample* from = samples.data() + width * (j + height * k);
            Real* to = coefficients_.data() + index(0, static_cast<int>(j), z);
            for (std::size_t i = 0; i < width; ++i)
                to[i] = static_cast<Real>(gain) * static_cast<Real>(from[i]);
        }
        if (filtered) filter_along_x(z);
        for (int j = 0; j < size_.y; ++j) {
            Real* to = coefficients_.data() + index(0, j, z);
            to[-1] = to[1];
            to[width] = to[width - 2];
        }
        if (filtered) filter_lines(coefficients_.data() + index(-1, 0, z), row_, size_.y, row_);
        mirror_border(z);
    });
    if (filtered)
        parallel_blocks(height + 2, 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j)
                filter_lines(coefficients_.data() +
                                 index(-1, static_cast<int>(j) - 1, first_slice_),
                             plane_, slices_, row_);
        });
    const auto plane_at = [&](int k) {
        return coefficients_.data() + index(-1, -1, first_slice_ + k);
    };
    std::copy_n(plane_at(1), plane_, plane_at(-1));
    std::copy_n(plane_at(slices_ - 2), plane_, plane_at(slices_));
}

// The first and the last row of a plane.
template <class Real> void ScalarField<Real>::mirror_border(int k)
{
    const auto row_at = [&](int j) { return coefficients_.data() + index(-1, j, k); };
    std::copy_n(row_at(1), row_, row_at(-1));
    std::copy_n(row_at(size_.y - 2), row_, row_at(size_.y));
}

// Rows along x are turned so that some of them are filtered side by side.
template <class Real> void ScalarField<Real>::filter_along_x(int k)
{
    const auto width = static_cast<std::size_t>(size_.x);
    std::vector<Real> turned(width * lanes);
    for (int first = 0; first < size_.y; first += lanes) {
        const int rows = std::min(lanes, size_.y - first);
        for (int r = 0; r < lanes; ++r) {
            const Real* from = coefficients_.data() + index(0, first + std::min(r, rows - 1), k);
            for (std::size_t i = 0; i < width; ++i)
                turned[i * lanes + static_cast<std::size_t>(r)] = from[i];
        }
        filter_lines(turned.data(), lanes, size_.x, lanes);
        for (int r = 0; r < rows; ++r) {
            Real* to = coefficients_.data() + index(0, first + r, k);
            for (std::size_t i = 0; i < width; ++i)
                to[i] = turned[i * lanes + static_cast<std::size_t>(r)];
        }
    }
}

// Filters `width` lines beside each other in place; those of one step are consecutive.
template <class Real>
void ScalarField<Real>::filter_lines(Real* first, std::size_t stride, int count,
                                     std::size_t width) const
{
    const double pole = prefilter_of(order_).pole;
    const Real z = static_cast<Real>(pole), last = static_cast<Real>(pole / (pole * pole - 1));
    const auto line = [&](int i) { return first + stride * static_cast<std::size_t>(i); };
    std::vector<Real> begin(width, Real(0));
    Real weight = 1;
    for (int i = 0; i < mirrored_terms; ++i, weight *= z) {
        const Real* from = line(mirrored(i, count));
        for (std::size_t x = 0; x < width; ++x) begin[x] += weight * from[x];
    }
    std::ranges::copy(begin, first);
    for (int i = 1; i < count; ++i) {
        Real* to = line(i);
        const Real* before = line(i - 1);
        for (std::size_t x = 0; x < width; ++x) to[x] += z * before[x];
    }
    Real* end = line(count - 1);
    const Real* before = line(count - 2);
    for (std::size_t x = 0; x < width; ++x) end[x] = last * (end[x] + z * before[x]);
    for (int i = count - 2; i >= 0; --i) {
        Real* to = line(i);
        const Real* after = line(i + 1);
        for (std::size_t x = 0; x < width; ++x) to[x] = z * (after[x] - to[x]);
    }
}

template class ScalarField<float>;
template class ScalarField<double>;
#define TRIVAR_FIELD_OF(Real, Sample)                                                        \
    template ScalarField<Real>::ScalarField(std::span<const Sample>, const glm::ivec3&,      \
                                            FieldSpline, FieldOrder);                        \
    template ScalarField<Real>::ScalarField(std::span<const Sample>, const glm::ivec3&, int, \
                                            FieldSpline, FieldOrder);
TRIVAR_FIELD_OF(float, std::uint8_t)
TRIVAR_FIELD_OF(float, std::int8_t)
TRIVAR_FIELD_OF(float, std::uint16_t)
TRIVAR_FIELD_OF(float, std::int16_t)
TRIVAR_FIELD_OF(float, float)
TRIVAR_FIELD_OF(double, float)
TRIVAR_FIELD_OF(double, double)
#undef TRIVAR_FIELD_OF

} // namespace trivar
