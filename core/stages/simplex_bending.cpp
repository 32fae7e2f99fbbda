// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/simplex_bending.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"
#include "core/stages/simplex_tears.h"

#include <algorithm>

namespace trivar {
namespace {

// The matrix that takes normals along with a linear map.
glm::dmat3 cofactors(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

// The mesh in the world, after the displacements of its bound points.
Mesh displaced(const SimplexBinding& bound, const Part& part, const TetrahedraInWorld& volume)
{
    const Mesh& mesh = *bound.mesh;
    const DisplacedPoints moved = bound.rows.displaced(volume.volume->displacements);
    const glm::dmat3 linear(volume.to_world), inverse = glm::inverse(linear),
                                              own(glm::dmat3(part.to_world));
    Mesh out = mesh;
    out.influences.clear();
    out.morph_targets.clear();
    const auto move = [&](std::size_t v) {
        const glm::dvec3 by(moved.positions[v] - bound.in_domain[v]);
        out.positions[v] = glm::vec3(
            glm::dvec3(part.to_world * glm::dvec4(glm::dvec3(mesh.positions[v]), 1)) + linear * by);
    };
    const auto turn = [&](std::size_t v) {
        const glm::dmat3 whole = linear * glm::dmat3(moved.jacobians[v]) * inverse * own;
        const glm::dvec3 normal =
            unit_or(cofactors(whole) * glm::dvec3(mesh.normals[v]), glm::dvec3(mesh.normals[v]));
        out.normals[v] = glm::vec3(normal);
        if (mesh.tangents.empty()) return;
        const glm::dvec3 tangent = whole * glm::dvec3(mesh.tangents[v]);
        out.tangents[v] = glm::vec4(glm::vec3(unit_or(tangent - normal * glm::dot(normal, tangent),
                                                      glm::dvec3(mesh.tangents[v]))),
                                    mesh.tangents[v].w);
    };
    constexpr std::size_t block = 4096;
    parallel_blocks(mesh.vertex_count(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            move(v);
            if (!mesh.normals.empty()) turn(v);
        }
    });
    return out;
}

} // namespace

SimplexBinding::SimplexBinding(const Ref<Mesh>& from, const glm::dmat4& to_domain,
                               std::span<const Ref<SimplexBasis<3>>> layers)
    : mesh(from)
{
    if (layers.front()->domain().cuts.empty()) {
        for (const glm::vec3& p : mesh->positions)
            in_domain.emplace_back(glm::dvec3(to_domain * glm::dvec4(glm::dvec3(p), 1)));
    } else {
        SimplexCut cut = cut_along(*mesh, to_domain, layers.front()->domain());
        mesh = make_ref(std::move(cut.mesh));
        in_domain.assign(cut.in_domain.begin(), cut.in_domain.end());
    }
    rows = SimplexRows(layers, in_domain, !mesh->normals.empty());
}

glm::dvec3 bent(const TetrahedraInWorld& volume, const glm::dvec3& p_world)
{
    const glm::dvec3 at(glm::inverse(volume.to_world) * glm::dvec4(p_world, 1));
    const glm::dvec3 by = evaluate(*volume.volume, at).position - at;
    return p_world + glm::dmat3(volume.to_world) * by;
}

SimplexBending::Reach SimplexBending::reach() const
{
    Reach out;
    for (const BoundPart& each : bound_) {
        out.points += each.binding->rows.point_count();
        out.outside += each.binding->rows.outside();
    }
    return out;
}

Part SimplexBending::operator()(const Part& part, const TetrahedraInWorld& volume)
{
    const std::vector<glm::dvec3>& d = volume.volume->displacements;
    if (std::ranges::all_of(d, [](const glm::dvec3& each) { return each == glm::dvec3(0); }))
        return part;
    const Ref<Mesh> mesh = part.before_volume();
    const auto found = std::ranges::find_if(bound_, [&](const BoundPart& b) {
        return b.part == part && b.layers == volume.volume->layers && b.to_world == volume.to_world;
    });
    const glm::dmat4 to_domain = glm::inverse(volume.to_world) * part.to_world;
    used_.push_back(
        found != bound_.end()
            ? *found
            : BoundPart{part, volume.volume->layers, volume.to_world,
                        Lazy<SimplexBinding>([mesh, to_domain, layers = volume.volume->layers] {
                            return SimplexBinding(mesh, to_domain, layers);
                        })});
    const Ref<Mesh> out = make_ref(displaced(*used_.back().binding, part, volume));
    return {.rest = out, .key = part.key, .bounds = bounding_box(*out)};
}

} // namespace trivar
