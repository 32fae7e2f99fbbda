// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace trivar {

// An ExactRecursion has the values of all DMS basis functions of a domain by the recursion of
// Micchelli in rational arithmetic: slow, and the truth. A point on the border of a simplex belongs
// to the side to which a direction leads. Determinants are kept from point to point. Not
// thread-safe.
template <int S> class ExactRecursion {
public:
    using Point = glm::vec<S, double>;

    explicit ExactRecursion(const SimplexDomain<S>& domain);
    ~ExactRecursion();

    // Returns the values by cell and multi-index. At most a few ms.
    std::vector<double> values(const Point& x, const Point& direction);

    // Whether a cell has x in it or on its faces.
    bool holds(std::size_t cell, const Point& x);
    // Whether x lies in the plane of the face opposite to a corner.
    bool on_plane(std::size_t cell, std::size_t corner, const Point& x);

private:
    struct Cell;
    std::vector<std::unique_ptr<Cell>> cells_;
    int degree_;
};

} // namespace trivar
