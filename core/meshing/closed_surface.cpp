// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/closed_surface.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <fmt/format.h>
#include <map>

namespace trivar {

namespace Surfaces = CGAL::Polygon_mesh_processing;

CgalSurface closed_surface(std::span<const glm::dvec3> positions,
                           std::span<const std::array<int, 3>> triangles)
{
    if (triangles.empty()) throw Rejected("The cage has no faces.");
    std::map<std::array<double, 3>, std::size_t> places;
    std::vector<CgalKernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& t : triangles) {
        std::vector<std::size_t> face;
        for (const int v : t) {
            if (v < 0 || v >= static_cast<int>(positions.size()))
                throw Rejected(
                    fmt::format("A face of the cage names vertex {} of {}.", v, positions.size()));
            const glm::dvec3& p = positions[static_cast<std::size_t>(v)];
            if (!finite(p) || glm::length(p) > 1e30)
                throw Rejected("A vertex of the cage is not a number, or too far away.");
            const auto [at, added] = places.try_emplace({p.x, p.y, p.z}, points.size());
            if (added) points.emplace_back(p.x, p.y, p.z);
            face.push_back(at->second);
        }
        if (CGAL::collinear(points[face[0]], points[face[1]], points[face[2]]))
            throw Rejected(fmt::format("Face {} of the cage has no area.", faces.size()));
        faces.push_back(std::move(face));
    }
    const std::size_t before = points.size();
    if (!Surfaces::orient_polygon_soup(points, faces) || points.size() != before ||
        !Surfaces::is_polygon_soup_a_polygon_mesh(faces))
        throw Rejected("The cage is not one surface: more than two faces meet at an edge, or two "
                       "parts of it in a vertex only.");
    CgalSurface out;
    Surfaces::polygon_soup_to_polygon_mesh(points, faces, out);
    if (!CGAL::is_closed(out)) throw Rejected("The cage is not closed: an edge has one face only.");
    if (Surfaces::does_self_intersect(out)) throw Rejected("The cage crosses itself.");
    Surfaces::orient_to_bound_a_volume(out);
    return out;
}

} // namespace trivar
