// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/ffd/embedding.h"
#include "core/mesh/mesh.h"

namespace trivar {

// A RefinePart is a mesh and its place in the volume, as Deformer takes them.
struct RefinePart {
    Ref<Mesh> mesh;
    Embedding embedding;
};

} // namespace trivar
