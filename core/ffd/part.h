// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/ffd/deform.h"
#include "core/mesh/extent.h"
#include "core/mesh/later_mesh.h"
#include "core/mesh/part_key.h"
#include "core/patches/tile_set.h"

namespace trivar {

struct Part;

// A Deformation says how a mesh lies in a volume, and gives the mesh in the world. The processor
// computes that when it is first asked for, on any thread, by one deformation of the vertices
// (core/ffd/deform.h). Where the graphics card draws, nobody asks. Of a part with a to_world the
// mesh is before that.
struct Deformation {
    Embedding embedding;
    Ref<Lattice> volume;
    Lazy<Ref<Mesh>> mesh;
    // the part in the volume that deformed its vertices before this one; null: none did
    Ref<Part> inner = nullptr;
};

// A Part is one mesh as it stands in the world: posed by its model's clip, and then deformed by a
// volume.
struct Part {
    LaterMesh rest; // has the same faces, corners and number of vertices as the result
    // Transforms mesh() to the world. After a volume, whose embedding gives world positions, it is
    // a shift: the vertices of a part far from the origin are relative to a point near it.
    glm::dmat4 to_world{1};
    Ref<PosedMesh> posed = nullptr;  // null where no skin and no morph target moves its vertices
    Ref<Deformation> bent = nullptr; // null where no volume does
    PartKey key = {};
    // Bounds of the posed vertices before to_world or the volume; they may be larger than needed.
    Box bounds = {};
    // The tiles of which `rest` is the mesh; null: it is no mesh of tiles. Code that needs no
    // single vertex reads these, so that they need not be bent.
    Ref<TileSet> tiles = nullptr;

    const Ref<Mesh>& before_volume() const { return posed ? *posed->mesh : rest.ref(); }
    const Ref<Mesh>& mesh() const { return bent ? *bent->mesh : before_volume(); }
    // Whether it is drawn from the tiles, and not from a mesh of all of them.
    bool drawn_from_tiles() const { return tiles && !posed && !bent; }
    std::size_t vertex_count() const
    {
        return tiles ? tiles->vertex_count() : rest->vertex_count();
    }
    std::size_t face_count() const { return tiles ? tiles->face_count() : rest->face_count(); }
    // The mesh before it was split, for patterns that fill a body and follow its vertices; null:
    // `rest`.
    Ref<Mesh> before_split = nullptr;
    // One entry for each step whose cuts passed over the part, the farthest base first. Bit i is
    // set if the part is above cut i.
    std::vector<unsigned> above_cuts = {};
    bool operator==(const Part& other) const // bounds and tiles follow from the other members
    {
        return rest == other.rest && to_world == other.to_world && posed == other.posed &&
               bent == other.bent && key == other.key && above_cuts == other.above_cuts;
    }
};

// The part in the first of the volumes that deform it, before all others.
const Part& innermost(const Part& part);

// The part with another mesh in the first of the volumes that deform it, which is deformed when
// somebody asks.
Part with_innermost(const Part& part, const Ref<Mesh>& mesh);

// Returns the world position, after all volumes of the part, of a point of the mesh that the first
// volume deforms, and its derivative by that point. In double precision.
DeformedPoint point_in_world(const Part& part, const glm::dvec3& p_object);
glm::dvec3 place_in_world(const Part& part, const glm::dvec3& p_object); // the position alone

// A part of tiles with that key, in the world.
Part part_of(const Ref<TileSet>& tiles, const PartKey& key);

// A box that holds the part in the world. Parts in volumes are deformed for it; tiles are not.
Box bounds_in_world(const Part& part);

// true also if nothing deforms the part: mesh() is there at once
bool is_deformed(const Part& part);

// The same mesh; the time of a deformation in this call is added as stage "deform".
const Ref<Mesh>& mesh_of(const Part& part, Timings& timings);

} // namespace trivar
