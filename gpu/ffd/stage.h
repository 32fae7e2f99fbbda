// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"

#include <array>
#include <optional>
#include <string_view>

namespace trivar::gpu {

// One volume of a stack, and how what comes out of the volume before lies in it.
struct Stage {
    Ref<Lattice> lattice;
    Embedding embedding;
    bool operator==(const Stage&) const = default;
};

// Where the meshes of a picture are deformed. One phase: as they are drawn, in every pass anew; all
// but the last volume of a stack, and meshes whose edges are drawn, take two phases all the same.
enum class DeformBy { processor, one_phase, two_phases };
inline constexpr std::array<std::string_view, 3> deform_names{"processor", "one_phase",
                                                              "two_phases"};
std::optional<DeformBy> deform_named(std::string_view name);
DeformBy usual_deform_by(); // the fastest of the current context: cards take two phases

} // namespace trivar::gpu
