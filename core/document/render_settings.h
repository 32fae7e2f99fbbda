// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace trivar {

// What colours show: the materials, by which factor the volume of what was placed changed, or the
// certified error of its triangles beside the tolerance.
enum class ColorBy { material, stretch, error };

// How the picture is made; part of the document. Colours are linear.
struct RenderSettings {
    std::string look = "studio"; // a named look of the renderer: studio, clay, dark
    double exposure = 0;         // stops
    double sun_azimuth = -1.7;   // radians round Z, 0 along +X
    double sun_elevation = 0.84; // radians above the horizon
    bool shadows = true;
    bool ambient_occlusion = true;
    bool wire = false; // the edges of the faces, drawn over them
    ColorBy color_by = ColorBy::material;
    bool volumes = false;  // the volumes of what was placed, and the ball of each one's last press
    bool captions = false; // what is refined has its triangles and its certified error under it
    bool ground = true;    // a shadow-catching ground under the scene
    bool operator==(const RenderSettings&) const = default;
};

} // namespace trivar
