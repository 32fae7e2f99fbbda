// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/mesh/mesh.h"
#include "core/mesh/model.h"

#include <span>

namespace trivar {

// Gives the pattern of a filling as colours of vertices, for files that know no such patterns: #V
// linear RGBA, by which a white material shows them. `at_rest` is the mesh before it was deformed,
// with the same vertices, and `box` holds all of it. Vertices of faces without a pattern keep their
// colours, or are white. Empty where no face has a pattern. What repeats finer than the edges at a
// vertex is left out, as it would only be noise. The formulas are those of the shaders
// (core/kernel/filling.glsl). O(#C), the same bits for any number of threads.
std::vector<glm::vec4> filling_colors(const Mesh& mesh, const Mesh& at_rest, const Box& box,
                                      std::span<const Material> materials);

// Finds the axis, 0..2, about which a body in that box may have been turned: the one round which
// the box is most nearly square; z in doubt. Metal has its marks round it.
int turning_axis(const Box& box);

// Gives the material with which a file shows these colours: white, without textures, as rough and
// as metallic as the pattern is on average. A material without a pattern stays what it is.
Material without_filling(const Material& material);

} // namespace trivar
