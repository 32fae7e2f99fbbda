// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

template <int S> struct CellBox {
    glm::vec<S, double> lo, hi;
};

// A BoxGrid finds the boxes that may hold a point: a regular grid with about two cells per box,
// each with the numbers of the boxes that touch it.
template <int S> class BoxGrid {
public:
    BoxGrid() = default;
    // O(number of boxes + number of touched cells). Throws Rejected where boxes overlap so much
    // that they touch more than 64 cells each, and a million in all.
    explicit BoxGrid(std::span<const CellBox<S>> boxes);
    // Ascending. O(1).
    std::span<const std::int32_t> boxes_at(const glm::vec<S, double>& x) const;

private:
    glm::vec<S, int> cell_of(const glm::vec<S, double>& x) const;
    std::size_t index(const glm::vec<S, int>& cell) const;

    glm::vec<S, double> origin_{0}, per_unit_{0};
    glm::vec<S, int> size_{0};
    std::vector<std::int32_t> begin_, boxes_;
};

} // namespace trivar
