// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/silhouette/ink.h"

#include <optional>
#include <string>

namespace trivar {

// A DrawingLayer is what one level gives to a drawing.
struct DrawingLayer {
    std::string name; // of the layer in the file
    std::vector<InkedLine> lines;
};

// Writes a drawing as a text of SVG 1.1: a group per layer and in it one for what is hidden, one
// path per line, its points with one digit after the point. Lines of one width are strokes, others
// filled outlines; one whose colour changes is a path per piece of one colour. Ids are made of the
// layer's name and the line's edge, so they stay from export to export. `paper` without a value has
// no background.
std::string svg_of(std::span<const DrawingLayer> layers, const glm::dvec2& size,
                   const std::optional<glm::vec3>& paper = glm::vec3(1));

} // namespace trivar
