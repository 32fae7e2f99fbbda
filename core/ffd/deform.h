// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/ffd/embedding.h"
#include "core/ffd/lattice.h"
#include "core/mesh/mesh.h"

#include <memory>

namespace trivar {

// A DeformedPoint is the world position of a point of the object, with the derivative of that
// position by the point. Computed in double precision; the reference for Deformer.
struct DeformedPoint {
    glm::dvec3 position_world;
    glm::dmat3 jacobian;
};
// Deforms one point by the definition. p_object: a point in object space, also beyond the lattice.
DeformedPoint deform(const glm::dvec3& p_object, const Embedding& embedding,
                     const Lattice& lattice);

// DeformedArrays holds the arrays of a mesh that a deformation changes; empty where the mesh has
// none.
struct DeformedArrays {
    std::vector<glm::vec3> positions, normals; // #V, world; normals unit
    std::vector<glm::vec4> tangents;           // #V, xyz unit and orthogonal to the normal
};

// A Deformer deforms one mesh by one lattice after another:
//
//   position  to_rest(p) + sum_ijk N_ijk(to_uvw(p)) D_ijk
//   normal    cof(J) n / |cof(J) n|, J the Jacobian of the line above by p: exact (Barr 1984)
//   tangent   J t made orthogonal to the normal; the handedness stays
//
// Vertices beyond an open axis move with the nearest end. A lattice of zeros returns to_rest(p)
// and, where to_rest is the identity, the exact bits of the mesh. Equal positions get equal bits.
// Tangents of a mesh without normals mean nothing and are dropped. Normals agree with the winding
// of the deformed faces, so where det J < 0 both look inwards. Where J gives no normal (rank 1) the
// deformed faces around the vertex give it.
class Deformer {
public:
    Deformer(Ref<Mesh> mesh, const Embedding& embedding, const std::array<Knots, 3>& axes);
    ~Deformer();
    Deformer(Deformer&&) noexcept;
    Deformer& operator=(Deformer&&) noexcept;

    // Deforms the mesh. `lattice` must have the axes given at construction; faces, UVs and colours
    // are copied.
    Mesh operator()(const Lattice& lattice) const;

    // The same without the copies. `reuse` may hold anything and gives its storage: moving the last
    // result in saves the allocation of the next one.
    DeformedArrays arrays(const Lattice& lattice, DeformedArrays reuse = {}) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Deforms a mesh once: Deformer with the arrays of the whole mesh.
Mesh deform(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice);

} // namespace trivar
