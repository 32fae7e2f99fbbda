// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Noise> {
    static constexpr std::string_view told_as = "values of [noise](#noise)";
    static void fields(auto& n, auto&& field)
    {
        field("amount", n.amount, "metres that a vertex is shifted by at most",
              not_negative.in(Unit::metres));
        field("seed", n.seed, "which of the random shifts", between(0, 1e6));
    }
};

} // namespace trivar
