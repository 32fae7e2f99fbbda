// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/grey_image.h"
#include "core/mesh/mesh.h"

namespace trivar {

// A HeightSheet says how a picture becomes a square sheet in z = 0, about the origin, whose points
// stand as high as the picture is bright: z = height (value - level).
struct HeightSheet {
    double size = 1;                    // side, metres
    double height = 0.1;                // metres from black to white
    double level = 0;                   // the value that stays in z = 0
    int segments = 64;                  // along each side
    ImageEdge edge = ImageEdge::repeat; // opposite borders are then equally high
    bool operator==(const HeightSheet&) const = default;

    double at(const GreyImage& image, const glm::dvec2& uv) const // metres
    {
        return height * (grey_at(image, uv, edge) - level);
    }
};

// The sheet, with the picture's lower left corner at -x -y, texture coordinates and normals of the
// heights between its points. Throws Rejected for an empty picture. O(#segments^2).
Mesh height_sheet(const GreyImage& image, const HeightSheet& sheet);

} // namespace trivar
