// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

namespace trivar {

// Lists the nodes of each group that one node with instances can show: two or more under one
// parent, with the same name and the same mesh, that have nothing below them, no skin, weights or
// curves, are no joints and move in no clip, and whose matrices are a translation, a rotation and
// scales above 0. Groups and nodes are in the order of the model.
std::vector<std::vector<int>> repeated_nodes(const Model& model);

// Moves these nodes behind all others, group by group, so that the others have the same numbers in
// a file with instances as in the model. Nodes with nothing below them whose mesh has no vertices
// are left out. The model must have no skins and no clips.
Model with_repeated_last(Model model);

} // namespace trivar
