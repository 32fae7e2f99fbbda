// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_levels.h"

#include "core/base/rejected.h"
#include "core/simplify/reach.h"
#include "core/simplify/simplify.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

std::size_t triangle_count(const Mesh& mesh)
{
    return mesh.corners.size() - 2 * mesh.face_count();
}

// Returns the greatest distance of vertices of the mesh, evenly taken, from another mesh.
double distance_at_samples(const Mesh& mesh, const Mesh& other)
{
    constexpr std::size_t most_samples = 400;
    struct Candidate {
        Triangle3 triangle;
        Box box;
    };
    std::vector<Candidate> all;
    for (const glm::uvec3& t : triangles(other)) {
        const Triangle3 triangle{other.positions[t.x], other.positions[t.y], other.positions[t.z]};
        all.push_back({triangle, box_of(triangle)});
    }
    double most = 0;
    const std::size_t step = std::max<std::size_t>(1, mesh.vertex_count() / most_samples);
    for (std::size_t v = 0; v < mesh.vertex_count(); v += step) {
        const glm::dvec3 p(mesh.positions[v]);
        double nearest = 1e300;
        for (const Candidate& each : all) {
            const double to_box = each.box.distance(p);
            if (to_box * to_box < nearest)
                nearest = std::min(nearest, distance_squared(p, each.triangle));
        }
        most = std::max(most, nearest);
    }
    return std::sqrt(most);
}

} // namespace

std::vector<TileLevel> levels_of(const Ref<Mesh>& mesh)
{
    // A tile of a few triangles costs as much as none.
    constexpr std::size_t least_triangles = 12, most_levels = 8;
    std::vector<TileLevel> out{{mesh, 0}};
    while (out.size() < most_levels) {
        const std::size_t triangles = triangle_count(*out.back().mesh);
        if (triangles <= least_triangles) break;
        try {
            SimplifyOptions options;
            options.triangles = triangles / 2;
            const SimplifiedMesh less = simplified(out.back().mesh, options);
            if (4 * triangle_count(*less.mesh) > 3 * triangles) break;
            const double error = distance_at_samples(*mesh, *less.mesh);
            out.push_back({less.mesh, std::max(error, out.back().error)});
        } catch (const Rejected&) {
            break; // what cannot be simplified has one level
        }
    }
    return out;
}

} // namespace trivar
