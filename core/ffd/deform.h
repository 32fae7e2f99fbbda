// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/ffd/lattice.h"
#include "core/mesh/mesh.h"

#include <memory>

namespace trivar {

// How an object lies in a lattice. Both maps are affine, from object space.
struct Embedding {
    glm::dmat4 to_uvw{1};
    glm::dmat4 to_rest{
        1}; // world position before deformation: rest(to_uvw(p)), often known exactly

    bool operator==(const Embedding&) const = default;
};

// Deforms one mesh by one lattice after another: positions by F, normals by the cofactor matrix of
// the Jacobian (exact; Barr 1984), tangents by the Jacobian and re-orthonormalised. Vertices
// are sorted by cell once, at construction; operator() is single precision, SIMD, parallel over
// blocks, and gives the same bits for any number of threads. A lattice of zeros returns positions
// equal to to_rest(p) and, where to_rest is the identity, the very bits of the mesh.
class Deformer {
public:
    Deformer(Ref<Mesh> mesh, const Embedding& embedding, const std::array<Knots, 3>& axes);
    ~Deformer();
    Deformer(Deformer&&) noexcept;
    Deformer& operator=(Deformer&&) noexcept;

    // The lattice must have the axes given at construction. Faces, UVs, colours are shared by copy.
    Mesh operator()(const Lattice& lattice) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

Mesh deform(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice);

} // namespace trivar
