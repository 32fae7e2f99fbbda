// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/copied_tiling.h"
#include "core/commands/cutting/split.h"

#include <vector>

namespace trivar {

// A CopiedSplitting names obstacles by what they were called, beside their numbers.
struct CopiedSplitting {
    Splitting splitting;
    std::vector<KnownObject> known; // in the order of its obstacles
    bool operator==(const CopiedSplitting&) const = default;
};

template <> struct FieldsOf<CopiedSplitting> {
    static constexpr std::string_view told_as = "values of [split](#split), and `known`";
    static void fields(auto& s, auto&& field)
    {
        spread(s.splitting, field);
        field("known", s.known, "the obstacles: other copies, or objects of the scene");
    }
};
} // namespace trivar
