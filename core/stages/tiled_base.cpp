// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/tiled_base.h"

#include "core/base/mean_scale.h"
#include "core/base/rejected.h"

#include <cmath>

namespace trivar {

glm::dmat4 mesh_to_model(const EvaluatedObject& base, const Object& object, const Part& part)
{
    if (object.tiles) return part.to_world; // its tiles are no meshes of its model
    for (const Shape::NodeMesh& each : base.shape->meshes) {
        if (each.slot != part.key.mesh) continue;
        const glm::dmat3 turned(object.transform.matrix());
        // A part in a volume was turned inside out before, if its node mirrors it.
        if (part.bent && object.stroke && glm::determinant(turned * glm::dmat3(each.to_model)) < 0)
            return glm::dmat4(glm::inverse(turned));
        return each.to_model;
    }
    return glm::dmat4(1);
}

TiledPieces pieces_of(const EvaluatedObject& base, const Object& object,
                      const std::vector<Part>& parts)
{
    TiledPieces out;
    for (const Part& part : parts) {
        TiledPiece piece{part.rest, mesh_to_model(base, object, part), {}};
        if (!object.tiles)
            for (const Shape::NodeMesh& each : base.shape->meshes)
                if (each.slot == part.key.mesh) piece.cage = {each.cage, each.to_model};
        out.push_back(std::move(piece));
    }
    return out;
}

std::map<int, std::vector<Part>> by_member(const EvaluatedObject& base)
{
    std::map<int, std::vector<Part>> out;
    for (const Part& part : base.whole()) out[part.key.member].push_back(part);
    return out;
}

FoundLimit LimitBases::operator()(const TiledPieces& pieces)
{
    std::vector<LimitBase::Piece> cages;
    for (const TiledPiece& piece : pieces)
        if (piece.cage.cage) cages.push_back(piece.cage);
    if (cages.empty() || cages.size() != pieces.size()) return {};
    return known_(cages, [](const std::vector<LimitBase::Piece>& in) -> FoundLimit {
        try {
            return {std::make_shared<const LimitBase>(in), {}};
        } catch (const Rejected& error) {
            return {nullptr, error.what()};
        }
    });
}

RestToWorld::RestToWorld(const Part& part, const glm::dmat4& to_model)
    : part_(part),
      to_part_(glm::inverse(to_model)),
      straight_(part.to_world * to_part_),
      normals_(glm::transpose(glm::inverse(glm::dmat3(straight_))))
{
}

DeformedPoint RestToWorld::at(const glm::dvec3& p_model) const
{
    DeformedPoint out = point_in_world(part_, glm::dvec3(to_part_ * glm::dvec4(p_model, 1)));
    out.jacobian = out.jacobian * glm::dmat3(to_part_);
    return out;
}

SurfacePoint RestToWorld::operator()(const SurfacePoint& at_rest) const
{
    SurfacePoint out;
    glm::dvec3 n(0);
    if (!part_.bent) {
        out.p = glm::dvec3(straight_ * glm::dvec4(at_rest.p, 1));
        n = normals_ * at_rest.normal;
    } else {
        const DeformedPoint there = at(at_rest.p);
        out.p = there.position_world;
        n = glm::transpose(glm::inverse(there.jacobian)) * at_rest.normal;
    }
    if (const double length = glm::length(n); length > 0 && std::isfinite(length))
        out.normal = n / length;
    return out;
}

bool RestToWorld::mirrors(const glm::dvec3& p_model) const
{
    return glm::determinant(at(p_model).jacobian) < 0;
}

double RestToWorld::scale(const glm::dvec3& p_model) const
{
    return mean_scale(at(p_model).jacobian);
}

std::vector<RestToWorld> ways_to_world(const TiledPieces& pieces, const std::vector<Part>& parts)
{
    std::vector<RestToWorld> out;
    for (std::size_t k = 0; k < parts.size(); ++k) out.emplace_back(parts[k], pieces[k].to_model);
    return out;
}

std::vector<char> mirrored_parts(const TiledPieces& pieces, const std::vector<Part>& parts)
{
    std::vector<char> out;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::vector<glm::vec3>& all = pieces[k].mesh->positions;
        const glm::dvec3 first = all.empty() ? glm::dvec3(0) : glm::dvec3(all.front());
        out.push_back(RestToWorld(parts[k], pieces[k].to_model)
                          .mirrors(glm::dvec3(pieces[k].to_model * glm::dvec4(first, 1))));
    }
    return out;
}

BasePose pose_of(const TileBase& base, const std::vector<Part>& parts,
                 const std::vector<char>& mirrored)
{
    BasePose pose;
    pose.points.reserve(base.points().size());
    for (const Part& part : parts) {
        const Mesh& mesh = *part.mesh();
        const std::size_t before = pose.points.size();
        pose.points.resize(before + point_count(mesh));
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            pose.points[before + mesh.point(v)] =
                glm::dvec3(part.to_world * glm::dvec4(mesh.positions[v], 1));
    }
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) {
        triangles.push_back(base.triangle(t));
        // A mirror on the way to the world turns the faces round, as it does in the picture.
        if (mirrored[base.piece_of(t)]) std::swap(triangles.back().y, triangles.back().z);
    }
    pose.normals = angle_normals(pose.points, triangles);
    return pose;
}

} // namespace trivar
