// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/ffd/deform.h"
#include "core/mesh/extent.h"
#include "core/mesh/part_key.h"

namespace trivar {

// How a mesh lies in a volume, and what comes out of it in the world: worked out by the processor
// when it is first asked for, by whichever thread, with one deformation of its vertices
// (core/ffd/deform.h). Who draws by the graphics card does not ask.
struct Deformation {
    Embedding embedding;
    Ref<Lattice> volume;
    Lazy<Ref<Mesh>> mesh;
    bool again = false; // another volume bent the vertices of the mesh before
};

// One mesh as it stands in the world: posed by its model's clip, and then deformed by a volume.
struct Part {
    Ref<Mesh> rest;         // has the same faces, corners and number of vertices as what it becomes
    glm::dmat4 to_world{1}; // identity where a volume deforms it
    Ref<PosedMesh> posed = nullptr;  // null where no skin and no morph target moves its vertices
    Ref<Deformation> bent = nullptr; // null where no volume does
    PartKey key = {};
    Box bounds = {}; // before to_world or the volume, of its vertices as they are posed; or larger

    const Ref<Mesh>& before_volume() const { return posed ? *posed->mesh : rest; }
    const Ref<Mesh>& mesh() const { return bent ? *bent->mesh : before_volume(); }
    bool operator==(const Part& other) const // bounds follow from the others
    {
        return rest == other.rest && to_world == other.to_world && posed == other.posed &&
               bent == other.bent && key == other.key;
    }
};

bool is_deformed(const Part& part); // or needs not to be: mesh() is there at once

// The same mesh; what the deforming took, if it was done for this call, is the stage "deform".
const Ref<Mesh>& mesh_of(const Part& part, Timings& timings);

} // namespace trivar
