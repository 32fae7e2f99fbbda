// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/render_settings.h"
#include "core/document/object.h"
#include "gpu/level.h"
#include "gpu/picture.h"
#include "ui/theme.h"

#include <optional>

namespace trivar {

// Shading says how the window shows surfaces; it is no part of the scene and its pictures.
struct Shading {
    bool wireframe = false;   // nothing but the edges of the faces, those behind too
    bool see_through = false; // what is behind shows through
    bool edges = false;       // over the surfaces
    bool operator==(const Shading&) const = default;
};

// A ViewportStyle says how the window shows the scene, beyond the scene's own settings for
// pictures.
struct ViewportStyle {
    std::optional<gpu::Backdrop> backdrop; // with a grid; none: as in pictures
    gpu::Outline outline;
    gpu::Level level = gpu::Level::standard; // of what is at rest
    gpu::DeformBy deform_by = gpu::DeformBy::processor;
    bool grid = true;    // of a backdrop
    double draft_ms = 0; // what a picture of what moves may take; 0: as fits the graphics card
    Shading shading = {};
    glm::vec3 edge_color{1}; // of a wireframe; linear
    ui::Look look = {};      // of what is drawn over the scene
    Id at_limits = 0;        // the layer whose tiles show how near they are to folding; 0: none
    bool operator==(const ViewportStyle&) const = default;
};
// `as_in_pictures`: the backdrop of the scene's look, else the theme's own.
ViewportStyle viewport_style(const ui::Theme& theme, bool as_in_pictures);

// The theme with the backdrop and the overlays that suit the scene: dark looks stay dark.
ui::Theme theme_over_picture(const ui::Theme& theme, const RenderSettings& settings,
                             bool as_in_pictures);

} // namespace trivar
