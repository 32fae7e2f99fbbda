// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<LatticeShape> {
    static constexpr std::string_view told_as = "values of [add_lattice](#add_lattice)",
                                      copied = "lattice";
    static void fields(auto& s, auto&& field)
    {
        field("size", s.size, "size of the box along X, Y and Z, metres; its middle is its origin",
              positive.in(Unit::metres));
        field("grid", s.grid, "control points along X, Y and Z",
              in_range(2, 1024).called("Density").without_keys());
        field("orders", s.orders,
              "order along X, Y and Z: 3 is quadratic, 4 is cubic; at most the number of control "
              "points",
              in_range(2, 6).called("Order").without_keys());
    }
};

} // namespace trivar
