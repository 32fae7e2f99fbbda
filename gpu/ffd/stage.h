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

// Where the meshes of a picture are deformed, and how. One phase: as they are drawn, in every pass
// anew; all but the last volume of a stack, and meshes whose edges are drawn, take two phases all
// the same. The last three are two phases as the thesis has them, to be compared with ours: normals
// by differences, and these of points summed by order raising, between whose control points the
// shader or the device's filter (a preview) looks up.
enum class DeformBy { processor, one_phase, two_phases, differences, raised, filtered };
inline constexpr std::array<std::string_view, 6> deform_names{
    "processor", "one_phase", "two_phases", "differences", "raised", "filtered"};
std::optional<DeformBy> deform_named(std::string_view name);
DeformBy usual_deform_by(); // the fastest of the current context: cards take two phases

} // namespace trivar::gpu
