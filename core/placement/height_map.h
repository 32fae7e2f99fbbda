// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <string>
#include <vector>

namespace trivar {

// Rows along the stroke; each row holds the values across it, from its right to its left.
using HeightGrid = std::vector<std::vector<double>>;

// A HeightMap changes the height over the whole strip. Its factor at (u, v) is a tensor-product
// B-spline over [0, 1]^2 with the grid's values as control points, on uniform knots, quadratic
// where there are at least three values. It never leaves the range of its values. Without a grid
// the factor is 1 everywhere; where all values are equal, it is exactly that value. Heights by u
// and v: Schein 2006, chapter 2.
class HeightMap {
public:
    // Throws Rejected as check_height_map does.
    explicit HeightMap(const HeightGrid& grid = {});
    double at(double u, double v) const; // O(1)
    double largest() const { return largest_; }
    // The Greville abscissae of the control points, along and across; only with a grid.
    const std::vector<double>& along() const { return along_.sites; }
    const std::vector<double>& across() const { return across_.sites; }
    // The weight of the value (i, j) at its own place, 0..1.
    double weight(int i, int j) const;

private:
    struct Axis {
        Axis() = default;
        explicit Axis(std::size_t count);
        Basis at(double t) const;
        Knots knots = Knots::uniform(2, 2);
        std::vector<double> sites;
    };
    Axis along_, across_;
    HeightGrid grid_; // empty where the height is even
    double even_ = 1, largest_ = 1;
};

// The grid of another size that is nearest to the same surface: its values at the new sites.
HeightGrid resampled(const HeightGrid& grid, int along, int across);

inline constexpr std::size_t least_map_points = 2, most_map_points = 32; // along and across each

// Throws Rejected, naming the field, for rows of different lengths, fewer than 2 or more than 32
// values along or across, and factors outside the range of a profile.
void check_height_map(const HeightGrid& grid, const std::string& name);

} // namespace trivar
