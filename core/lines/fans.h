// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/ink.h"
#include "core/silhouette/visibility.h"

namespace trivar {

// Fans stand on the lines that are seen, away from the body: five hairs that begin in one point of
// a line. They tell how the field falls off there: steep, and a fan is long and narrow; gentle, and
// it is short and wide (glyphs of the thesis, chapter 7). One line per fan, out and back.
// `to_image` maps voxels to pixels and depth; nothing where style.fan_step is 0.
std::vector<InkedLine> fans(const LevelBody& body, std::span<const Stroke> strokes,
                            const LineStyle& style, const glm::dmat4& to_image);

// Inks strokes, and their fans after them.
std::vector<InkedLine> inked_with_fans(const LevelBody& body, std::span<const Stroke> strokes,
                                       const LineStyle& style, const glm::dmat4& to_image);

} // namespace trivar
