// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplex/exact_recursion.h"

#include "core/simplex/multi_index.h"

#include <array>
#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <unordered_map>

namespace trivar {
namespace {

using Number = boost::multiprecision::mpq_rational;
template <int S> using Exact = std::array<Number, S>;

template <int S> Exact<S> exact(const glm::vec<S, double>& p)
{
    Exact<S> out;
    for (int i = 0; i < S; ++i) out[static_cast<std::size_t>(i)] = Number(p[i]);
    return out;
}

Number det(const std::array<Exact<2>, 2>& m)
{
    return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}
Number det(const std::array<Exact<3>, 3>& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[2][1] * m[1][2]) +
           m[0][1] * (m[1][2] * m[2][0] - m[2][2] * m[1][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[2][0] * m[1][1]);
}

// A plane is what the volume (times S!) of a simplex of a point and S knots is: affine in the
// point.
template <int S> struct Plane {
    Exact<S> normal;
    Number at_origin;
};

template <int S> Plane<S> plane_through(const std::array<Exact<S>, S>& knots)
{
    const auto from = [&](int axis) { // from 1 on an axis, or from the origin
        std::array<Exact<S>, S> edges = knots;
        for (Exact<S>& each : edges)
            if (axis >= 0) each[static_cast<std::size_t>(axis)] -= 1;
        return det(edges);
    };
    Plane<S> out{{}, from(-1)};
    for (int i = 0; i < S; ++i) out.normal[static_cast<std::size_t>(i)] = from(i) - out.at_origin;
    return out;
}

template <std::size_t S> Number dot(const std::array<Number, S>& a, const std::array<Number, S>& b)
{
    Number out = a[0] * b[0];
    for (std::size_t i = 1; i < S; ++i) out += a[i] * b[i];
    return out;
}

std::vector<std::uint32_t> bits_of(std::uint32_t mask)
{
    std::vector<std::uint32_t> out;
    for (; mask != 0; mask &= mask - 1) out.push_back(mask & -mask);
    return out;
}

} // namespace

// Sets of knots are masks: knot j of corner k is bit k (degree + 1) + j.
template <int S> struct ExactRecursion<S>::Cell {
    std::vector<Point> places;
    std::vector<Exact<S>> knots;
    std::unordered_map<std::uint32_t, Plane<S>> planes;
    std::unordered_map<std::uint32_t, Number> wholes;
    std::unordered_map<std::uint32_t, std::uint32_t> bases; // S + 1 knots that are in no plane
    // at one point
    Exact<S> x, direction;
    std::unordered_map<std::uint32_t, Number> at_x, splines;

    const Exact<S>& knot(std::uint32_t bit) const
    {
        return knots[static_cast<std::size_t>(std::countr_zero(bit))];
    }

    const Plane<S>& plane(std::uint32_t mask)
    {
        const auto found = planes.find(mask);
        if (found != planes.end()) return found->second;
        std::array<Exact<S>, S> through;
        std::size_t n = 0;
        for (const std::uint32_t bit : bits_of(mask)) through[n++] = knot(bit);
        return planes.emplace(mask, plane_through<S>(through)).first->second;
    }

    const Number& volume(std::uint32_t mask) // times S!, signed, knots ascending
    {
        const auto found = wholes.find(mask);
        if (found != wholes.end()) return found->second;
        const Plane<S>& base = plane(mask & (mask - 1));
        return wholes.emplace(mask, dot(base.normal, knot(mask & -mask)) + base.at_origin)
            .first->second;
    }

    const Number& value_at_x(std::uint32_t mask)
    {
        const auto found = at_x.find(mask);
        if (found != at_x.end()) return found->second;
        const Plane<S>& p = plane(mask);
        return at_x.emplace(mask, dot(p.normal, x) + p.at_origin).first->second;
    }

    // Calls body with each set of S + 1 knots of some until it returns true.
    template <class Body>
    bool each_simplex(const std::vector<std::uint32_t>& bits, std::size_t from,
                      std::uint32_t chosen, const Body& body) const
    {
        if (std::popcount(chosen) == S + 1) return body(chosen);
        for (std::size_t i = from; i < bits.size(); ++i)
            if (each_simplex(bits, i + 1, chosen | bits[i], body)) return true;
        return false;
    }

    std::uint32_t basis(std::uint32_t mask) // 0: all lie in one plane
    {
        const auto found = bases.find(mask);
        if (found != bases.end()) return found->second;
        std::uint32_t out = 0;
        each_simplex(bits_of(mask), 0, 0, [&](std::uint32_t simplex) {
            if (volume(simplex) == 0) return false;
            out = simplex;
            return true;
        });
        return bases[mask] = out;
    }

    // M(x | knots) of integral 1.
    Number spline(std::uint32_t mask)
    {
        const auto found = splines.find(mask);
        if (found != splines.end()) return found->second;
        const int n = std::popcount(mask) - S - 1;
        const std::uint32_t base = basis(mask);
        Number out = 0;
        if (base != 0 && n == 0)
            out = of_simplex(mask);
        else if (base != 0) {
            bool turned = false; // moving x to the front of the other corners
            for (const std::uint32_t bit : bits_of(base)) {
                const Number& at = value_at_x(base & ~bit);
                if (at != 0) {
                    const Number part = at * spline(mask & ~bit);
                    if (turned)
                        out -= part;
                    else
                        out += part;
                }
                turned = !turned;
            }
            out *= Number(n + S, n) / volume(base);
        }
        splines.emplace(mask, out);
        return out;
    }

    Number of_simplex(std::uint32_t mask)
    {
        const Number& whole = volume(mask);
        bool turned = whole < 0;
        for (const std::uint32_t bit : bits_of(mask)) {
            int side = value_at_x(mask & ~bit).sign();
            if (side == 0) side = dot(plane(mask & ~bit).normal, direction).sign();
            if (turned ? side > 0 : side < 0) return 0;
            turned = !turned;
        }
        return (S == 3 ? 6 : 2) / abs(whole);
    }
};

template <int S>
ExactRecursion<S>::ExactRecursion(const SimplexDomain<S>& domain) : degree_(domain.degree)
{
    for (const auto& corners : domain.cells) {
        auto cell = std::make_unique<Cell>();
        for (const int v : corners)
            for (int j = 0; j <= degree_; ++j) {
                cell->places.push_back(domain.knot(v, j));
                cell->knots.push_back(exact<S>(domain.knot(v, j)));
            }
        cells_.push_back(std::move(cell));
    }
}

template <int S> ExactRecursion<S>::~ExactRecursion() = default;

template <int S>
std::vector<double> ExactRecursion<S>::values(const Point& x, const Point& direction)
{
    int factor = 1; // (n + S)! / n!
    for (int i = 1; i <= S; ++i) factor *= degree_ + i;
    std::vector<double> out;
    for (const auto& cell : cells_) {
        cell->x = exact<S>(x);
        cell->direction = exact<S>(direction);
        cell->at_x.clear();
        cell->splines.clear();
        for (const MultiIndex<S>& index : multi_indices<S>(degree_)) {
            std::uint32_t knots = 0, last = 0;
            for (std::size_t k = 0; k <= S; ++k)
                for (int j = 0; j <= index[k]; ++j) {
                    const auto bit = 1U << (static_cast<int>(k) * (degree_ + 1) + j);
                    knots |= bit;
                    if (j == index[k]) last |= bit;
                }
            bool beside = false;
            for (int i = 0; i < S; ++i) {
                bool below = true, above = true;
                for (std::size_t n = 0; n < cell->places.size(); ++n)
                    if ((knots >> n & 1U) != 0) {
                        below = below && x[i] < cell->places[n][i];
                        above = above && x[i] > cell->places[n][i];
                    }
                beside = beside || below || above;
            }
            out.push_back(beside ? 0
                                 : static_cast<double>(abs(cell->volume(last)) *
                                                       cell->spline(knots) / factor));
        }
    }
    return out;
}

template <int S>
bool ExactRecursion<S>::on_plane(std::size_t cell, std::size_t corner, const Point& x)
{
    std::uint32_t face = 0;
    for (std::size_t k = 0; k <= S; ++k)
        if (k != corner) face |= 1U << (static_cast<int>(k) * (degree_ + 1));
    const Plane<S>& plane = cells_[cell]->plane(face);
    return dot(plane.normal, exact<S>(x)) + plane.at_origin == 0;
}

template <int S> bool ExactRecursion<S>::holds(std::size_t cell, const Point& x)
{
    std::uint32_t corners = 0;
    for (std::size_t k = 0; k <= S; ++k) corners |= 1U << (static_cast<int>(k) * (degree_ + 1));
    bool turned = false; // cells are of positive orientation
    const Exact<S> at = exact<S>(x);
    for (const std::uint32_t bit : bits_of(corners)) {
        const Plane<S>& plane = cells_[cell]->plane(corners & ~bit);
        const Number side = dot(plane.normal, at) + plane.at_origin;
        if (turned ? side > 0 : side < 0) return false;
        turned = !turned;
    }
    return true;
}

template class ExactRecursion<2>;
template class ExactRecursion<3>;

} // namespace trivar
