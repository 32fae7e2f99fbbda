// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/simplex_tears.h"

#include "core/split/sever.h"

#include <algorithm>

namespace trivar {
namespace {

struct CutPlane {
    glm::dvec3 point, normal;
};

struct CutPlanes {
    std::vector<CutPlane> planes;
    std::size_t passed_over = 0; // cut faces in none of them
};

double size_of(const SimplexDomain<3>& domain)
{
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const glm::dvec3& knot : domain.knots) {
        lo = glm::min(lo, knot);
        hi = glm::max(hi, knot);
    }
    return glm::length(hi - lo);
}

CutPlanes planes_of(const SimplexDomain<3>& domain, double size)
{
    CutPlanes out;
    for (const auto& face : domain.cuts) {
        const glm::dvec3 &a = domain.vertex(face[0]), &b = domain.vertex(face[1]),
                         &c = domain.vertex(face[2]);
        const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
        const bool known = std::ranges::any_of(out.planes, [&](const CutPlane& p) {
            return glm::length(glm::cross(p.normal, n)) < 1e-6 &&
                   std::abs(glm::dot(p.normal, a - p.point)) < 1e-6 * size;
        });
        if (known) continue;
        if (out.planes.size() < most_cut_planes)
            out.planes.push_back({a, n});
        else
            ++out.passed_over;
    }
    return out;
}

struct Piece {
    Mesh mesh;
    std::vector<bool> above; // one per plane
};

std::vector<Piece> pieces_of(const Mesh& mesh, const glm::dmat4& to_domain,
                             const std::vector<CutPlane>& planes)
{
    std::vector<Piece> all{{mesh, {}}};
    all[0].mesh.influences.clear();
    all[0].mesh.morph_targets.clear();
    SeverOptions options;
    options.material = mesh.face_material.empty() ? 0 : mesh.face_material.front();
    for (const CutPlane& plane : planes) {
        const CutSheet sheet({.point = plane.point, .normal = plane.normal}, to_domain);
        std::vector<Piece> next;
        for (Piece& each : all) {
            Unsevered where;
            std::optional<Severed> made = sever(each.mesh, sheet, options, where);
            if (!made) {
                each.above.push_back(where.above);
                next.push_back(std::move(each));
                continue;
            }
            for (const bool side : {false, true}) {
                next.push_back({std::move(made->halves[side ? 1 : 0]), each.above});
                next.back().above.push_back(side);
            }
        }
        all = std::move(next);
    }
    return all;
}

template <class T>
void append(std::vector<T>& to, std::size_t had, const std::vector<T>& more, std::size_t count,
            const T& otherwise)
{
    if (to.empty() && more.empty()) return;
    to.resize(had, otherwise);
    to.insert(to.end(), more.begin(), more.end());
    to.resize(had + count, otherwise);
}

void append(Mesh& to, const Mesh& more)
{
    const std::size_t had = to.vertex_count(), count = more.vertex_count();
    const std::size_t faces = to.face_count(), new_faces = more.face_count();
    append(to.normals, had, more.normals, count, glm::vec3(0, 0, 1));
    append(to.tangents, had, more.tangents, count, glm::vec4(1, 0, 0, 1));
    append(to.colors, had, more.colors, count, glm::vec4(1));
    to.uvs.resize(std::max(to.uvs.size(), more.uvs.size()));
    for (std::size_t set = 0; set < to.uvs.size(); ++set)
        append(to.uvs[set], had, set < more.uvs.size() ? more.uvs[set] : std::vector<glm::vec2>{},
               count, glm::vec2(0));
    append(to.face_material, faces, more.face_material, new_faces, 0U);
    append(to.face_group, faces, more.face_group, new_faces, 0U);
    to.group_names = more.group_names;
    to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
    const auto corner = static_cast<std::uint32_t>(to.corners.size());
    for (const std::uint32_t c : more.corners)
        to.corners.push_back(c + static_cast<std::uint32_t>(had));
    for (std::size_t f = 1; f < more.face_begin.size(); ++f)
        to.face_begin.push_back(corner + more.face_begin[f]);
}

} // namespace

std::size_t cuts_passed_over(const SimplexDomain<3>& domain)
{
    return planes_of(domain, size_of(domain)).passed_over;
}

SimplexCut cut_along(const Mesh& mesh, const glm::dmat4& to_domain, const SimplexDomain<3>& domain)
{
    const double size = size_of(domain), near = 2e-6 * size;
    const std::vector<CutPlane> planes = planes_of(domain, size).planes;
    SimplexCut out;
    bool numbered = false;
    std::vector<std::uint32_t> points; // of the surface: they stay those of their piece
    std::uint32_t next_point = 0;
    for (const Piece& piece : pieces_of(mesh, to_domain, planes)) {
        if (piece.mesh.face_count() == 0) continue;
        for (const glm::vec3& p : piece.mesh.positions) {
            glm::dvec3 at(to_domain * glm::dvec4(glm::dvec3(p), 1));
            for (std::size_t i = 0; i < planes.size(); ++i)
                if (std::abs(glm::dot(planes[i].normal, at - planes[i].point)) < near)
                    at += planes[i].normal * (piece.above[i] ? 2 * near : -2 * near);
            out.in_domain.push_back(at);
        }
        append(out.mesh, piece.mesh);
        numbered = numbered || !piece.mesh.points.empty();
        const std::uint32_t first = next_point;
        for (std::uint32_t v = 0; v < piece.mesh.vertex_count(); ++v) {
            points.push_back(first + piece.mesh.point(v));
            next_point = std::max(next_point, points.back() + 1);
        }
    }
    if (numbered) out.mesh.points = std::move(points);
    return out;
}

} // namespace trivar
