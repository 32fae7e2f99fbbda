// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/deform.h"

#include "core/base/parallel.h"
#include "core/ffd/normals.h"

#include <cassert>

namespace trivar {
namespace {

glm::dmat3 cofactor(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

} // namespace

DeformedPoint deform(const glm::dvec3& p_object, const Embedding& embedding, const Lattice& lattice)
{
    const glm::dvec4 p(p_object, 1);
    const Lattice still{lattice.displacement, glm::dmat4(0)};
    const Jet<glm::dvec3> jet = evaluate(still, glm::dvec3(embedding.to_uvw * p), 1);
    const glm::dmat3 by_uvw(jet.first[0], jet.first[1], jet.first[2]);
    return {glm::dvec3(embedding.to_rest * p) + jet.value,
            glm::dmat3(embedding.to_rest) + by_uvw * glm::dmat3(embedding.to_uvw)};
}

struct Deformer::State {
    Ref<Mesh> mesh;
    Embedding embedding;
    std::array<Knots, 3> axes;
};

Deformer::Deformer(Ref<Mesh> mesh, const Embedding& embedding, const std::array<Knots, 3>& axes)
    : state_(new State{std::move(mesh), embedding, axes})
{
}

Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

Deformed Deformer::arrays(const Lattice& lattice, Deformed reuse) const
{
    assert(lattice.displacement.axes == state_->axes);
    const Mesh& mesh = *state_->mesh;
    Deformed out = std::move(reuse);
    out.positions.resize(mesh.positions.size());
    out.normals.resize(mesh.normals.size());
    out.tangents.resize(mesh.normals.empty() ? 0 : mesh.tangents.size());
    parallel_blocks(mesh.vertex_count(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const DeformedPoint at =
                deform(glm::dvec3(mesh.positions[v]), state_->embedding, lattice);
            out.positions[v] = glm::vec3(at.position_world);
            if (mesh.normals.empty()) continue;
            const glm::dvec3 n = cofactor(at.jacobian) * glm::dvec3(mesh.normals[v]);
            const double length = glm::length(n);
            out.normals[v] = length > 0 ? glm::vec3(n / length) : glm::vec3(0);
            if (mesh.tangents.empty()) continue;
            out.tangents[v] = glm::vec4(glm::vec3(at.jacobian * glm::dvec3(mesh.tangents[v])),
                                        mesh.tangents[v].w);
        }
    });
    if (!mesh.normals.empty())
        out.normals = fill_missing_normals(mesh, out.positions, std::move(out.normals));
    for (std::size_t v = 0; v < out.tangents.size(); ++v)
        out.tangents[v] = orthogonal_tangent(out.tangents[v], out.normals[v]);
    return out;
}

Mesh Deformer::operator()(const Lattice& lattice) const
{
    Mesh out = *state_->mesh;
    Deformed moved = arrays(lattice);
    out.positions = std::move(moved.positions);
    out.normals = std::move(moved.normals);
    out.tangents = std::move(moved.tangents);
    return out;
}

Mesh deform(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice)
{
    return Deformer(make_ref(mesh), embedding, lattice.displacement.axes)(lattice);
}

} // namespace trivar
