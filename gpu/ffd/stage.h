// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"

#include <array>
#include <optional>
#include <string_view>

namespace trivar::gpu {

// A Stage is one volume of a stack, with the embedding of the previous volume's result in it.
struct Stage {
    Ref<Lattice> lattice;
    Embedding embedding;
    bool operator==(const Stage&) const = default;
};

// DeformBy says where and how the meshes of a picture are deformed. One phase: as they are drawn,
// anew in every pass; the volumes of a stack before the last one, and meshes whose edges are drawn,
// still take two phases. The last three ways are two phases after the thesis, to be compared with
// ours: normals by differences of points, and these points summed by order raising, where the
// shader or the device's filter (a preview) interpolates between control points.
enum class DeformBy { processor, one_phase, two_phases, differences, raised, filtered };
inline constexpr std::array<std::string_view, 6> deform_names{
    "processor", "one_phase", "two_phases", "differences", "raised", "filtered"};
std::optional<DeformBy> deform_named(std::string_view name);
DeformBy usual_deform_by(); // the fastest way of the current context: two phases on graphics cards

} // namespace trivar::gpu
