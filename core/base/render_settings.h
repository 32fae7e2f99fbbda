// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace trivar {

// ColorBy says what colours show: the materials, the factor by which the volume of a placed object
// changed, the certified error of its triangles relative to the tolerance, how texture coordinates
// (UVs) change angles and areas, or a checkered texture.
enum class ColorBy { material, stretch, error, uv_angles, uv_areas, uv_checker };

// RenderSettings say how the picture is made; they are part of the document. Colours are linear.
struct RenderSettings {
    std::string look = "studio"; // a named look of the renderer, see gpu/look.h
    double exposure = 0;         // stops
    double sun_azimuth = -1.7;   // radians round Z, 0 along +X
    double sun_elevation = 0.84; // radians above the horizon
    bool shadows = true;
    bool ambient_occlusion = true;
    bool wire = false; // the edges of the faces, drawn over them
    ColorBy color_by = ColorBy::material;
    // shows the volumes of placed objects, and the ball of each one's last press
    bool volumes = false;
    // writes number of triangles and certified error under each refined object
    bool captions = false;
    bool ground = true; // a shadow-catching ground under the scene
    bool operator==(const RenderSettings&) const = default;
};

} // namespace trivar
