// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <fmt/format.h>

namespace trivar {

// A point near the model from which its positions keep their detail in single precision.
glm::dvec3 far_origin(const Model& model);

// All meshes of the model at their places, as one mesh, relative to a point. Where some of them
// lack an attribute, they get a neutral one: smooth normals, white, texture coordinate 0.
Mesh flattened(const Model& model, const glm::dvec3& origin = glm::dvec3(0));

// Writes the three numbers of a place relative to a point; where that is 0, the shortest ones that
// read back as the same in single precision.
void add_place(fmt::memory_buffer& text, const glm::vec3& p, const glm::dvec3& origin);

} // namespace trivar
