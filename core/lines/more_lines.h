// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

namespace trivar {

// MoreLines says which lines of a surface are drawn besides its outlines.
struct MoreLines {
    bool suggestive = false; // where an outline would appear from a view nearby [DeCarlo 2003]
    bool ridges = false;     // where the surface is bent most, outward
    bool valleys = false;    // or inward
    bool parabolic = false;  // between what is bent like a ball and what is bent like a saddle
    int isophotes = 0;       // number of lines of equal light, from where the light grazes on
    glm::vec3 light{-0.5f, -0.6f, 0.65f}; // direction toward it, in the object's own space
    float smoothing = 2.4f; // voxels, or sides of triangles, over which the surface is smoothed
    float detail = 1;       // 2: lines half as distinct are drawn, too
    float width = 0.6f;     // of these lines, as a share of that of outlines
    float amount = 1;       // share of all lines, outlines too: those that tell most
    bool operator==(const MoreLines&) const = default;
    bool any() const { return suggestive || ridges || valleys || parabolic || isophotes > 0; }
};

// The kinds of lines of a drawing.
enum class LineKind : std::uint8_t {
    silhouettes,
    borders,
    creases,
    intersections,
    suggestive,
    ridges,
    valleys,
    parabolic,
    isophotes
};
// Returns the name for the user.
std::string_view words_of(LineKind kind);

} // namespace trivar
