// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/deform.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/ffd/kernel.h"
#include "core/ffd/normals.h"

#include <algorithm>
#include <span>

namespace trivar {
DeformedPoint deform(const glm::dvec3& p_object, const Embedding& embedding, const Lattice& lattice)
{
    const glm::dvec4 p(p_object, 1);
    const Lattice still{lattice.displacement, glm::dmat4(0)};
    const Jet<glm::dvec3> jet = evaluate(still, glm::dvec3(embedding.to_uvw * p), 1);
    const glm::dmat3 by_uvw(jet.first[0], jet.first[1], jet.first[2]);
    return {glm::dvec3(embedding.to_rest * p) + jet.value,
            glm::dmat3(embedding.to_rest) + by_uvw * glm::dmat3(embedding.to_uvw)};
}

namespace {

void put_back(std::span<const std::uint32_t> place, std::size_t begin, const glm::vec3* from,
              glm::vec3* to)
{
    for (std::size_t v = 0; v < place.size(); ++v) to[v] = from[place[v] - begin];
}

// Deforms a chunk in the order of computation and copies the results to the order of the mesh.
// Returns whether normals are missing. Writing directly in mesh order is slower: random loads
// overlap, random stores hardly do.
bool deform_chunk(const SortedVertices& vertices, std::size_t chunk,
                  const CellPolynomials& polynomials, const Mesh& mesh, DeformedArrays& out)
{
    const std::size_t begin = vertices.runs[vertices.chunk_begin[chunk]].begin,
                      end = vertices.runs[vertices.chunk_begin[chunk + 1] - 1].end,
                      room = end - begin + SortedVertices::slack;
    const auto array = [room](bool wanted) {
        return wanted ? std::make_unique_for_overwrite<glm::vec3[]>(room) : nullptr;
    };
    const auto positions = array(true), normals = array(!out.normals.empty()),
               tangents = array(!out.tangents.empty());
    const bool missing = deform_chunk(vertices, chunk, polynomials,
                                      {begin, positions.get(), normals.get(), tangents.get()});
    const std::span<const std::uint32_t> place(vertices.place.data() + begin, end - begin);
    put_back(place, begin, positions.get(), out.positions.data() + begin);
    if (normals) put_back(place, begin, normals.get(), out.normals.data() + begin);
    if (tangents)
        for (std::size_t v = begin; v < end; ++v)
            out.tangents[v] = {tangents[place[v - begin] - begin], mesh.tangents[v].w};
    return missing;
}

} // namespace

struct Deformer::State {
    Ref<Mesh> mesh;
    Embedding embedding;
    std::array<Knots, 3> axes;
    std::array<AxisCells, 3> cells;
    SortedVertices vertices;
};

Deformer::Deformer(Ref<Mesh> mesh, const Embedding& embedding, const std::array<Knots, 3>& axes)
{
    const std::array<AxisCells, 3> cells{AxisCells(axes[0]), AxisCells(axes[1]),
                                         AxisCells(axes[2])};
    SortedVertices vertices = sort_by_cell(*mesh, embedding, axes, cells);
    state_.reset(new State{std::move(mesh), embedding, axes, cells, std::move(vertices)});
}

Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

DeformedArrays Deformer::arrays(const Lattice& lattice, DeformedArrays reuse) const
{
    const State& s = *state_;
    ensure(lattice.displacement.axes == s.axes, "a lattice has other knots than those sorted into");
    DeformedArrays out = std::move(reuse);
    out.positions.resize(s.mesh->positions.size());
    out.normals.resize(s.mesh->normals.size());
    out.tangents.resize(out.normals.empty() ? 0 : s.mesh->tangents.size());

    const CellPolynomials polynomials =
        cell_polynomials(lattice.displacement, s.cells, s.vertices.cells, s.embedding);
    const std::size_t chunks = s.vertices.chunk_begin.size() - 1;
    std::vector<unsigned char> missing(chunks, 0); // per chunk; not bits, for parallel writes
    parallel_blocks(chunks, 1, [&](std::size_t chunk, std::size_t) {
        missing[chunk] = deform_chunk(s.vertices, chunk, polynomials, *s.mesh, out);
    });
    if (std::find(missing.begin(), missing.end(), 1) == missing.end()) return out;
    out.normals = fill_missing_normals(*s.mesh, out.positions, std::move(out.normals));
    for (std::size_t v = 0; v < out.tangents.size(); ++v)
        if (glm::vec3(out.tangents[v]) == glm::vec3(0))
            out.tangents[v] = orthogonal_tangent(s.mesh->tangents[v], out.normals[v]);
    return out;
}

Mesh Deformer::operator()(const Lattice& lattice) const
{
    const Mesh& mesh = *state_->mesh;
    DeformedArrays moved = arrays(lattice);
    Mesh out;
    out.colors = mesh.colors;
    out.uvs = mesh.uvs;
    out.points = mesh.points;
    out.corners = mesh.corners;
    out.face_begin = mesh.face_begin;
    out.face_material = mesh.face_material;
    out.face_group = mesh.face_group;
    out.group_names = mesh.group_names;
    out.creases = mesh.creases;
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
