// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"
#include "core/level/tetrahedra_fit.h"

namespace trivar {

template <> struct FieldsOf<TetrahedraFit> {
    static constexpr std::string_view told_as = "[fit](#fit)",
                                      about = "A spline over tetrahedra that shows volume data.";
    static void fields(auto& f, auto&& field)
    {
        field("coefficients", f.coefficients,
              "at most so many, from 100 on; 0: the spline through the samples is shown",
              in_range(0, 30000).called("Tetrahedra").zero_is("off").without_keys());
        field("degree", f.degree, "1: piecewise linear, 2 and 3: smooth",
              in_range(1, 3).called("Degree").without_keys());
        field("boundary", f.boundary,
              "value of the data along which the function may jump, as from bone to air",
              in_range(-1e30, 1e30).called("Boundary").without_keys());
    }
};

} // namespace trivar
