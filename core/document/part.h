// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/timing.h"
#include "core/ffd/deform.h"

namespace trivar {

// A mesh in a volume. Who draws by the graphics card needs no more than the first three; the mesh
// as it comes out, in the world, is for the rest: worked out by the processor when it is first
// asked for, by whichever thread, with one deformation of its vertices (core/ffd/deform.h).
struct Bent {
    Ref<Mesh> rest;
    Embedding embedding;
    Ref<Lattice> volume;
    Lazy<Ref<Mesh>> mesh;
};

// One mesh as it stands in the world.
struct Part {
    Ref<Mesh> still;          // null where it was deformed
    glm::dmat4 to_world{1};   // identity where it was
    Ref<Bent> bent = nullptr; // null where it was not

    const Ref<Mesh>& mesh() const { return bent ? *bent->mesh : still; }
    // Before it was deformed: with the same faces, corners and number of vertices.
    const Ref<Mesh>& rest() const { return bent ? bent->rest : still; }
    bool operator==(const Part&) const = default;
};

// The same mesh; what the deforming took, if it was done for this call, is the stage "deform".
const Ref<Mesh>& mesh_of(const Part& part, Timings& timings);

} // namespace trivar
