// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/second_derivatives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace trivar {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> pairs{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

// Returns the corner at which two edges meet that are parallel to parameter axes; -1 if none.
int axis_parallel_corner(const std::array<glm::dvec3, 3>& uvw)
{
    const auto axis_of_leg = [](const glm::dvec3& leg) {
        int axis = -1;
        for (int a = 0; a < 3; ++a)
            if (std::abs(leg[a]) > 1e-12 * glm::length(leg)) axis = axis < 0 ? a : 3;
        return axis;
    };
    for (int i = 0; i < 3; ++i) {
        const int p = axis_of_leg(uvw[at((i + 1) % 3)] - uvw[at(i)]),
                  q = axis_of_leg(uvw[at((i + 2) % 3)] - uvw[at(i)]);
        if (p >= 0 && q >= 0 && p < 3 && q < 3 && p != q) return i;
    }
    return -1;
}

bool takes_unit_directions(BoundMethod method)
{
    return method == BoundMethod::thesis_circumradius || method == BoundMethod::circumradius ||
           method == BoundMethod::waldron;
}

} // namespace

template <int corners>
SecondDerivatives<corners>::SecondDerivatives(BoundMethod method,
                                              const std::array<glm::dvec3, corners>& uvw)
    : method_(method),
      uvw_(uvw)
{
    if constexpr (corners == 2) {
        along_[0] = {-1, 1, 0};
    } else if (!takes_unit_directions(method)) {
        directions_ = 3;
        along_ = {glm::dvec3(-1, 1, 0), glm::dvec3(0, -1, 1), glm::dvec3(1, 0, -1)};
    } else {
        // The longest edge comes first, so that a flat triangle has at least one direction.
        int longest = 0;
        for (int i = 1; i < 3; ++i)
            if (glm::distance(uvw[at(i)], uvw[at((i + 1) % 3)]) >
                glm::distance(uvw[at(longest)], uvw[at((longest + 1) % 3)]))
                longest = i;
        const int end = (longest + 1) % 3, top = (longest + 2) % 3;
        const glm::dvec3 e = uvw[at(end)] - uvw[at(longest)], f = uvw[at(top)] - uvw[at(longest)];
        const double length = glm::length(e);
        if (!(length > 0)) return; // a point
        along_[0][end] = 1 / length;
        along_[0][longest] = -1 / length;
        const double foot = glm::dot(f, e) / length, height = glm::length(f - foot * e / length);
        if (!(height > 1e-13 * length)) return;
        directions_ = 2;
        along_[1][top] = 1;
        along_[1][longest] = -1;
        along_[1] = (along_[1] - foot * along_[0]) / height;
        if (method == BoundMethod::waldron) return;
        // The thesis uses the coordinates of the parameter plane: the axis that is most nearly in
        // the triangle.
        const glm::dvec3 x = e / length, y = (f - foot * x) / height;
        const glm::dvec3 in_plane = x * x + y * y;
        const int axis = in_plane.x >= in_plane.y && in_plane.x >= in_plane.z ? 0
                         : in_plane.y >= in_plane.z                           ? 1
                                                                              : 2;
        const glm::dvec2 turn = glm::normalize(glm::dvec2(x[axis], y[axis]));
        along_ = {turn.x * along_[0] + turn.y * along_[1], turn.x * along_[1] - turn.y * along_[0]};
    }
}

template <int corners>
bool SecondDerivatives<corners>::worth_cutting(const std::array<glm::dvec3, corners>& weight) const
{
    if constexpr (corners == 2)
        return std::abs(weight[1].y - weight[0].y) > 1e-6;
    else
        return std::abs(glm::determinant(glm::dmat3(weight[0], weight[1], weight[2]))) > 1e-6;
}

template <int corners>
void SecondDerivatives<corners>::add(const NetPoints<corners>& net, int degree,
                                     const std::array<glm::dvec3, corners>& weight, double doubt)
{
    std::array<glm::dvec3, 3> along{}; // barycentric in the piece
    if constexpr (corners == 2) {
        along[0] = along_[0] / (weight[1].y - weight[0].y);
    } else {
        const glm::dmat3 to_piece = glm::inverse(glm::dmat3(weight[0], weight[1], weight[2]));
        for (std::size_t i = 0; i < 3; ++i) along[i] = to_piece * along_[i];
    }
    const double factor = degree * (degree - 1);
    const auto size = [](const glm::dvec3& v) { return glm::dot(glm::abs(v), glm::dvec3(1)); };
    const auto second = [&](const glm::dvec3& p, const glm::dvec3& q, int r, int c) {
        glm::dvec4 sum(0);
        for (int i = 0; i < corners; ++i)
            for (int j = 0; j < corners; ++j)
                sum += net[at(net_index<corners>(r + (i > 0) + (j > 0), c + (i == 2) + (j == 2)))] *
                       (p[i] * q[j] * factor);
        return sum;
    };
    each_term<corners>(degree - 2, [&](int, int r, int c) {
        std::array<glm::dvec4, 6> d{};
        for (std::size_t n = 0; n < pairs.size(); ++n) {
            const std::size_t i = pairs[n][0], j = pairs[n][1];
            if (std::max(i, j) >= at(directions_)) continue;
            d[n] = second(along[i], along[j], r, c);
            const double most =
                glm::length(d[n]) + 4 * factor * size(along[i]) * size(along[j]) * doubt;
            if (!(most <= greatest_[n]))
                greatest_[n] = std::isnan(most) ? std::numeric_limits<double>::infinity() : most;
        }
        if (method_ != BoundMethod::waldron) return;
        if (directions_ == 1) {
            any_direction_ = greatest_[0];
            return;
        }
        // (xx + yy)/2 + (xx - yy)/2 cos + xy sin of twice the angle is convex in (cos, sin): over a
        // polygon round the circle its length is greatest at a corner.
        constexpr int polygon = 64;
        const double out = 1 / std::cos(std::numbers::pi / polygon);
        for (int k = 0; k < polygon; ++k) {
            const double angle = 2 * std::numbers::pi * k / polygon;
            const glm::dvec4 v = (d[0] + d[1]) / 2.0 +
                                 (d[0] - d[1]) / 2.0 * (out * std::cos(angle)) +
                                 d[3] * (out * std::sin(angle));
            const double largest = std::max(size(along[0]), size(along[1]));
            any_direction_ =
                std::max(any_direction_, glm::length(v) + 8 * factor * largest * largest * doubt);
        }
    });
}

template <int corners> double SecondDerivatives<corners>::bound() const
{
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    if constexpr (corners == 2) {
        return greatest_[0] / 8;
    } else {
        // Corner i is between the edges i and i + 2; M2 of it is number 3 + (i + 2) % 3.
        const auto at_corner = [&](int i) {
            return greatest_[at(i)] + 2 * greatest_[at(3 + (i + 2) % 3)] +
                   greatest_[at((i + 2) % 3)];
        };
        const double radius = circumradius(uvw_), squared = radius * radius;
        switch (method_) {
        case BoundMethod::thesis_right_angled: {
            const int corner = axis_parallel_corner(uvw_);
            return corner < 0 ? unbounded : at_corner(corner) / 8;
        }
        case BoundMethod::thesis: return at_corner(2) / 2;
        case BoundMethod::barycentric: return at_corner(2) / 8;
        case BoundMethod::best_corner:
            return std::min({at_corner(0), at_corner(1), at_corner(2)}) / 8;
        case BoundMethod::thesis_circumradius:
            return directions_ < 2 ? unbounded
                                   : squared / 2 * (greatest_[0] + greatest_[3] / 2 + greatest_[1]);
        case BoundMethod::circumradius:
            return directions_ < 2 ? unbounded
                                   : squared / 2 * (greatest_[0] + greatest_[3] + greatest_[1]);
        default: {
            const double r = least_circle_radius(uvw_);
            return r * r / 2 * any_direction_;
        }
        }
    }
}

template class SecondDerivatives<2>;
template class SecondDerivatives<3>;

} // namespace trivar
