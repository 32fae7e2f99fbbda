// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar {

// Every mesh of the model at its place, as one mesh. An attribute that some lack gets what changes
// nothing: smooth normals, white, texture coordinate 0.
Mesh flattened(const Model& model);

} // namespace trivar
