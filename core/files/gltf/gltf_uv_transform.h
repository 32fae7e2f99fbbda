// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/counted_notices.h"
#include "core/files/gltf/gltf_entry.h"

#include <array>
#include <glm/vec2.hpp>
#include <string>

namespace trivar {

inline constexpr std::size_t most_uv_sets = 8;

// KHR_texture_transform: where the texture coordinates of a set lie on a picture. In glTF's own
// coordinates, v down; the rotation in radians, counter-clockwise as it is seen.
struct UvTransform {
    glm::dvec2 offset{0}, scale{1};
    double rotation = 0;
    glm::vec2 operator()(const glm::vec2& uv) const;
    bool operator==(const UvTransform&) const = default;
};

using UvTransforms = std::array<UvTransform, most_uv_sets>;

// The transforms of a material's textures, one for each set of texture coordinates. Where textures
// on one set differ the first of them counts, beginning with the base colour, and the others are a
// notice.
UvTransforms uv_transforms(const GltfEntry& material, CountedNotices& notices);

// The set that a texture lies on: the extension may say another than the texture itself.
std::size_t uv_set_of(const GltfEntry& texture);

} // namespace trivar
