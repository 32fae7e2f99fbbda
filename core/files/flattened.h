// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar {

// All meshes of the model at their places, as one mesh. Where some of them lack an attribute, they
// get a neutral one: smooth normals, white, texture coordinate 0.
Mesh flattened(const Model& model);

} // namespace trivar
