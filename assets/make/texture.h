// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

// The colours of a mesh's surface as a picture over its texture coordinates, u wrapping round:
// `color` is asked at the surface point behind each texel, so a pattern can be finer than the mesh.
// Texels that no face covers take their neighbours' colour.
Texture bake(const Mesh& mesh, glm::ivec2 size_px, const std::function<vec3(vec3)>& color);

std::string png(const Texture& texture); // the bytes of a PNG file, not compressed

// One channel of 16 bits: rows from the top, from 0 to 1.
struct GreyPicture {
    glm::ivec2 size_px{0};
    std::vector<float> values;
};
std::string png(const GreyPicture& picture);

} // namespace make
