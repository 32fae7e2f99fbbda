// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// A FaceShading says where a shape looks smooth and where it shows edges: as its file has it
// (`own`), or by its faces (core/mesh/shading.h).
enum class ShadingWay { own, smooth, by_angle, flat };
struct FaceShading {
    ShadingWay way = ShadingWay::own;
    double angle_deg = 35; // by_angle: faces that meet at more have an edge between them
    bool operator==(const FaceShading&) const = default;
};

} // namespace trivar
