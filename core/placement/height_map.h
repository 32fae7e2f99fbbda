// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <string>
#include <vector>

namespace trivar {

// Rows along the stroke, in each the values across it, from its right to its left.
using HeightGrid = std::vector<std::vector<double>>;

// How the height changes over the whole strip: the factor at (u, v) as a tensor-product B-spline
// over [0, 1]^2 with the grid's values as control points, on uniform knots, quadratic where there
// are three or more of them. It never leaves the range of its values. Without a grid it is 1
// everywhere; where all values are one, exactly that. Heights by u and v: Schein 2006, chapter 2.
class HeightMap {
public:
    // Throws Rejected as check_height_map does.
    explicit HeightMap(const HeightGrid& grid = {});
    double at(double u, double v) const; // O(1)
    double largest() const { return largest_; }
    // Where the control points stand, Greville abscissae, along and across; not without a grid.
    const std::vector<double>& along() const { return along_.sites; }
    const std::vector<double>& across() const { return across_.sites; }
    // What the value (i, j) counts for there where it stands, 0..1.
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
    HeightGrid grid_; // empty where it is even
    double even_ = 1, largest_ = 1;
};

// The same surface as nearly as a grid of another size has it: its values at the new sites.
HeightGrid resampled(const HeightGrid& grid, int along, int across);

inline constexpr std::size_t least_map_points = 2, most_map_points = 32; // each way

// Throws Rejected, naming the field, for rows of several lengths, fewer than 2 or more than 32
// values either way, and factors beyond the range of a profile's.
void check_height_map(const HeightGrid& grid, const std::string& name);

} // namespace trivar
