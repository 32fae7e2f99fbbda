// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"

#include <array>
#include <vector>

namespace trivar {

// A TetrahedronGlyph is a small regular tetrahedron that stands upright in every view, lit from the
// left: it marks a place, and has no directions of its own.
class TetrahedronGlyph {
public:
    TetrahedronGlyph();

    // Paints one; its corners lie `radius_px` from the middle.
    void paint(const ui::Theme& theme, glm::vec2 at, float radius_px, ui::Color color) const;

private:
    struct Face {
        std::array<glm::vec2, 3> corners; // of radius 1
        float light;                      // 1: of the colour that is asked for
    };
    std::vector<Face> faces_; // those that are seen
};

} // namespace trivar
