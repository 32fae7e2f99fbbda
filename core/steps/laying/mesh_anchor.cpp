// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/mesh_anchor.h"

#include <algorithm>

namespace trivar {
namespace {

// Computes the barycentric coordinates of the point of a triangle nearest to p. Ericson 2004,
// 5.1.5.
glm::dvec3 nearest_shares(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t)
{
    const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const glm::dvec3 bp = p - t[1];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double v = d1 / (d1 - d3);
        return {1 - v, v, 0};
    }
    const glm::dvec3 cp = p - t[2];
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double w = d2 / (d2 - d6);
        return {1 - w, 0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

std::array<glm::dvec3, 3> corners(const Mesh& mesh, const glm::uvec3& t)
{
    return {glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
            glm::dvec3(mesh.positions[t.z])};
}

glm::dvec3 mixed(const std::array<glm::dvec3, 3>& t, const glm::dvec3& shares)
{
    return shares.x * t[0] + shares.y * t[1] + shares.z * t[2];
}

// Says whether a mesh has the faces of the other with reversed corners, as after mirroring.
bool is_turned_round(const Mesh& mesh, const Mesh& other)
{
    constexpr std::size_t a_face = 3;
    return &mesh != &other && mesh.corners.size() >= a_face && other.corners.size() >= a_face &&
           !std::equal(mesh.corners.begin(), mesh.corners.begin() + a_face, other.corners.begin());
}

} // namespace

Ref<Mesh> rest_mesh(const Shape& shape, int slot)
{
    const auto found = std::ranges::find(shape.meshes, slot, &Shape::NodeMesh::slot);
    return found == shape.meshes.end() ? nullptr : found->rest;
}

MeshAnchor nearest_anchor(const RayMesh& mesh, const glm::dvec3& p)
{
    const std::vector<glm::uvec3>& all = mesh.triangles();
    MeshAnchor best;
    double least = 1e300;
    for (std::size_t b = 0; b < mesh.block_boxes().size(); ++b) {
        if (mesh.block_boxes()[b].distance(p) > least) continue;
        const std::size_t end = std::min(all.size(), (b + 1) * RayMesh::block);
        for (std::size_t i = b * RayMesh::block; i < end; ++i) {
            const auto t = corners(mesh.mesh(), all[i]);
            const glm::dvec3 shares = nearest_shares(p, t);
            const double distance = glm::distance(p, mixed(t, shares));
            if (!(distance < least)) continue;
            least = distance;
            best = {all[i], shares};
        }
    }
    return best;
}

std::optional<AnchorPlace> MeshAnchors::operator()(const AttachedSample& sample, std::size_t index,
                                                   const EvaluatedObject& host,
                                                   const std::vector<Part>& parts,
                                                   const StepInput& input)
{
    const Ref<Mesh> rest = rest_mesh(*host.shape, sample.mesh);
    if (!rest) return {};
    const auto find_in = [&](const std::vector<Part>& among) {
        return std::ranges::find_if(among, [&](const Part& part) {
            return part.key.mesh == sample.mesh && part.key.member == sample.member &&
                   part.rest->vertex_count() == rest->vertex_count();
        });
    };
    auto part = find_in(parts);
    if (part == parts.end()) { // its triangles have been split meanwhile
        part = find_in(host.own_parts);
        if (part == host.own_parts.end()) return {};
    }
    if (!part->posed && !part->bent)
        return AnchorPlace{glm::dvec3(part->to_world * glm::dvec4(sample.rest, 1)), sample.normal};
    known_.resize(std::max(known_.size(), index + 1));
    std::optional<SampleAnchor>& known = known_[index];
    if (!known || known->mesh != rest || known->rest != sample.rest) {
        const Ref<RayMesh> rays = input.ray_meshes(rest, input.timings);
        if (rays->triangles().empty()) return {};
        known = {sample.rest, rest, nearest_anchor(*rays, sample.rest)};
    }
    const auto t = corners(*mesh_of(*part, input.timings), known->anchor.vertices);
    std::array<glm::dvec3, 3> own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = glm::dvec3(part->to_world * glm::dvec4(t[i], 1));
    const glm::dvec3 normal = glm::cross(own[1] - own[0], own[2] - own[0]);
    const bool inside_out = glm::determinant(glm::dmat3(part->to_world)) < 0;
    const double length =
        glm::length(normal) * (inside_out != is_turned_round(*part->rest, *rest) ? -1 : 1);
    return AnchorPlace{mixed(own, known->anchor.shares),
                       length != 0 ? normal / length : glm::dvec3(0)};
}

} // namespace trivar
