// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/ffd/embedding.h"
#include "core/mesh/mesh.h"

namespace trivar {

// A mesh and how it lies in the volume: what Deformer takes.
struct RefinePart {
    Ref<Mesh> mesh;
    Embedding embedding;
};

} // namespace trivar
