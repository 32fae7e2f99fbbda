// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/silhouette/silhouettes.h"

#include <optional>

namespace trivar {

// A SeenPart is the part of silhouettes that an image can show, and by point whether it is hidden.
struct SeenPart {
    Silhouettes curves;
    std::vector<char> hidden;
};

// Cuts from silhouettes what lies behind the eye, or so near before it that it would be further
// than 65,536 pixels from the image's corner. `to_image` maps voxels to pixels and depth,
// homogeneous, with depth 0 at the near plane. None: all can be shown. O(n).
std::optional<SeenPart> seen_part(const Silhouettes& silhouettes, const std::vector<char>& hidden,
                                  const glm::dmat4& to_image);

} // namespace trivar
