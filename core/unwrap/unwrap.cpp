// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/unwrap.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/base/watched.h"
#include "core/unwrap/chart_tree.h"
#include "core/unwrap/disk.h"
#include "core/unwrap/pack.h"
#include "core/unwrap/uv_stretch.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace trivar {
namespace {

constexpr int rigid_rounds = 30;

// One chart, flat and as large as it is on its mesh.
struct FlatChart {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> corners, point_of_corner; // of all its faces
    std::vector<glm::dvec2> map;                         // by point
    std::vector<std::uint32_t> rim;                      // points
};

// The triangles of each face of a mesh by corners.
struct Fans {
    std::vector<glm::uvec3> triangles; // those of face f begin at face_begin[f] - 2 f
};

Fans fans_of(const Mesh& mesh)
{
    // Corners in place of vertices, so that a triangle knows the corners that it came from
    Mesh corners;
    corners.face_begin = mesh.face_begin;
    for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
        corners.positions.push_back(mesh.positions[mesh.corners[c]]);
        corners.corners.push_back(c);
    }
    return {triangles(corners)};
}

class Flattening {
public:
    Flattening(const ManifoldSurface& surface, const ChartTree& tree, const Fans& fans,
               double scale, const UnwrapOptions& options)
        : surface_(surface),
          tree_(tree),
          fans_(fans),
          scale_(scale),
          method_(options.method),
          most_(options.stretch)
    {
    }

    // The charts that one becomes. `about` is called before each that is tried.
    std::vector<FlatChart> operator()(std::uint32_t node, std::size_t& divided,
                                      const std::function<void()>& about) const
    {
        std::vector<FlatChart> out;
        std::vector<std::uint32_t> open{node};
        while (!open.empty()) {
            about();
            const std::uint32_t each = open.back();
            open.pop_back();
            FlatChart chart;
            const Disk disk = disk_of(tree_.faces(each), chart);
            chart.map = map_of(disk);
            if (is_folded(disk, chart.map) || stretch(disk, chart.map) > most_) {
                if (!tree_.is_face(each)) {
                    ++divided;
                    open.insert(open.end(), {tree_.right(each), tree_.left(each)});
                    continue;
                }
                if (is_folded(disk, chart.map)) chart.map = circle_map(disk);
                resize(disk, chart.map);
            }
            chart.rim = rim_of(disk);
            const glm::dmat2 turn = smallest_box_turn(chart.map);
            for (glm::dvec2& p : chart.map) p = turn * p;
            out.push_back(std::move(chart));
        }
        return out;
    }

private:
    Disk disk_of(std::vector<std::uint32_t> faces, FlatChart& chart) const
    {
        const Mesh& mesh = surface_.mesh();
        Disk disk;
        chart.faces = std::move(faces);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> known; // vertex and corner
        for (const std::uint32_t f : chart.faces)
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                chart.corners.push_back(c);
                known.emplace_back(surface_.vertex(c), c);
            }
        std::ranges::sort(known);
        std::vector<std::uint32_t> vertices;
        for (const auto& [v, c] : known)
            if (vertices.empty() || vertices.back() != v) {
                vertices.push_back(v);
                disk.points.push_back(scale_ * glm::dvec3(mesh.positions[mesh.corners[c]]));
            }
        const auto number = [&](std::uint32_t corner) {
            return static_cast<std::uint32_t>(
                std::ranges::lower_bound(vertices, surface_.vertex(corner)) - vertices.begin());
        };
        for (const std::uint32_t c : chart.corners) chart.point_of_corner.push_back(number(c));
        for (const std::uint32_t f : chart.faces)
            for (std::uint32_t t = mesh.face_begin[f] - 2 * f;
                 t < mesh.face_begin[f + 1] - 2 * (f + 1); ++t) {
                const glm::uvec3& c = fans_.triangles[t];
                disk.triangles.emplace_back(number(c.x), number(c.y), number(c.z));
            }
        return disk;
    }

    std::vector<glm::dvec2> map_of(const Disk& disk) const
    {
        std::vector<glm::dvec2> map = conformal_map(disk);
        resize(disk, map);
        if (method_ == UnwrapMethod::rigid && !is_folded(disk, map)) {
            std::vector<glm::dvec2> rigid = rigid_map(disk, map, rigid_rounds);
            resize(disk, rigid);
            if (!is_folded(disk, rigid)) return rigid;
        }
        return map;
    }

    // The factor by which lengths are off where they are off most; triangles that are next to
    // nothing do not count.
    static double stretch(const Disk& disk, const std::vector<glm::dvec2>& map)
    {
        std::vector<double> bent;
        double sum = 0;
        for (const glm::uvec3& t : disk.triangles)
            sum += bent.emplace_back(glm::length(glm::cross(disk.points[t.y] - disk.points[t.x],
                                                            disk.points[t.z] - disk.points[t.x])));
        double worst = 1;
        for (std::size_t k = 0; k < bent.size(); ++k) {
            if (bent[k] * static_cast<double>(bent.size()) < 1e-3 * sum) continue;
            const glm::uvec3& t = disk.triangles[k];
            const UvStretch s = uv_stretch({disk.points[t.x], disk.points[t.y], disk.points[t.z]},
                                           {map[t.x], map[t.y], map[t.z]});
            worst = std::max({worst, s.most, 1 / s.least});
        }
        return worst;
    }

    static void resize(const Disk& disk, std::vector<glm::dvec2>& map)
    {
        double flat = 0, bent = 0;
        for (const glm::uvec3& t : disk.triangles) {
            const glm::dvec2 a = map[t.y] - map[t.x], b = map[t.z] - map[t.x];
            flat += a.x * b.y - a.y * b.x;
            bent += glm::length(glm::cross(disk.points[t.y] - disk.points[t.x],
                                           disk.points[t.z] - disk.points[t.x]));
        }
        // A chart without area becomes as small as single precision allows.
        const double factor = flat > 0 ? std::sqrt(bent / flat) : 0;
        for (glm::dvec2& p : map) p *= factor;
    }

    const ManifoldSurface& surface_;
    const ChartTree& tree_;
    const Fans& fans_;
    double scale_;
    UnwrapMethod method_;
    double most_;
};

void check_meshes(std::span<const UnwrapInput> meshes)
{
    std::size_t faces = 0;
    for (const UnwrapInput& each : meshes) {
        faces += each.mesh->face_count();
        for (const glm::vec3& p : each.mesh->positions)
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                throw Rejected("a vertex has a position that is no number");
    }
    if (faces == 0) throw Rejected("there are no faces to unwrap");
}

// Calls told(triangle, texture coordinates) for all triangles that are in a chart.
void each_triangle(const UnwrapInput& input, const std::vector<std::uint32_t>& chart,
                   const std::vector<glm::vec2>& uvs, auto&& told)
{
    const Mesh& mesh = *input.mesh;
    const Fans fans = fans_of(mesh);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t t = mesh.face_begin[f] - 2 * f; t < mesh.face_begin[f + 1] - 2 * (f + 1);
             ++t) {
            if (chart[f] == ManifoldSurface::none) continue;
            std::array<glm::dvec3, 3> p;
            std::array<glm::dvec2, 3> uv;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t c = fans.triangles[t][static_cast<int>(k)];
                p[k] = input.scale * glm::dvec3(mesh.positions[mesh.corners[c]]);
                uv[k] = uvs[c];
            }
            told(p, uv);
        }
}

// The value that all but a thousandth of the area is below.
double nearly_worst(std::vector<std::pair<double, double>> values_and_areas, double area)
{
    std::ranges::sort(values_and_areas, std::greater<>());
    double worse = 0;
    for (const auto& [value, its_area] : values_and_areas)
        if ((worse += its_area) >= 1e-3 * area) return value;
    return 1;
}

void measure(std::span<const UnwrapInput> meshes, Unwrapped& out)
{
    double flat = 0, bent = 0;
    std::vector<UvStretch> stretches;
    std::vector<double> areas;
    for (std::size_t m = 0; m < meshes.size(); ++m)
        each_triangle(meshes[m], out.chart[m], out.uvs[m], [&](const auto& p, const auto& uv) {
            const UvStretch stretch = uv_stretch(p, uv);
            const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2;
            flat += area * stretch.area();
            bent += area;
            if (!(stretch.least > 0)) return;
            stretches.push_back(stretch);
            areas.push_back(area);
        });
    out.facts.filled = flat;
    if (!(bent > 0) || !(flat > 0)) return;
    const double usual = std::sqrt(flat / bent);
    std::vector<std::pair<double, double>> angles, lengths;
    for (std::size_t k = 0; k < areas.size(); ++k) {
        const UvStretch& s = stretches[k];
        angles.emplace_back(s.angle(), areas[k]);
        lengths.emplace_back(std::max(s.most / usual, usual / s.least), areas[k]);
    }
    out.facts.angle = nearly_worst(std::move(angles), bent);
    out.facts.length = nearly_worst(std::move(lengths), bent);
}

// `progress` is called on several threads at the same time.
Unwrapped unwrapped_here(std::span<const UnwrapInput> meshes, const UnwrapOptions& options,
                         const Progress& progress)
{
    check_meshes(meshes);
    Unwrapped out;
    std::vector<std::vector<FlatChart>> charts; // of all meshes, by the charts of their trees
    std::vector<std::size_t> mesh_of;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const double begin = 0.9 * static_cast<double>(m) / static_cast<double>(meshes.size()),
                     share = 0.9 / static_cast<double>(meshes.size());
        report(progress, begin, "charts");
        const Mesh& mesh = *meshes[m].mesh;
        const ManifoldSurface surface(mesh);
        const Progress joining = part_of(progress, begin, begin + 0.4 * share);
        const ChartTree tree(surface, {options.seam_angle, options.spread}, joining);
        report(progress, begin + 0.4 * share, "flatten");
        const Fans fans = fans_of(mesh);
        const Flattening flatten(surface, tree, fans, meshes[m].scale, options);
        const std::size_t first = charts.size(), count = tree.charts().size();
        charts.resize(first + count);
        mesh_of.resize(first + count, m);
        std::vector<std::size_t> divided(count, 0);
        std::atomic<std::size_t> done{0};
        parallel_blocks(count, 1, [&](std::size_t k, std::size_t) {
            const double part = static_cast<double>(done++) / static_cast<double>(count);
            const double now = begin + share * (0.4 + 0.6 * part);
            charts[first + k] =
                flatten(tree.charts()[k], divided[k], [&] { report(progress, now, "flatten"); });
        });
        for (const std::size_t each : divided) out.facts.divided += each;
        out.facts.left_out += surface.left_out();
        out.uvs.emplace_back(mesh.corners.size(), glm::vec2(0));
        out.chart.emplace_back(mesh.face_count(), ManifoldSurface::none);
    }
    const Progress packing_progress = part_of(progress, 0.9, 1);
    std::vector<std::vector<glm::dvec2>> outlines;
    for (const auto& each : charts)
        for (const FlatChart& chart : each) {
            outlines.emplace_back();
            for (const std::uint32_t p : chart.rim) outlines.back().push_back(chart.map[p]);
        }
    const Packing packing = packed(outlines, options.margin, packing_progress);
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < charts.size(); ++i)
        for (const FlatChart& chart : charts[i]) {
            const PackedPlace& place = packing.places[number];
            for (const std::uint32_t f : chart.faces) out.chart[mesh_of[i]][f] = number;
            for (std::size_t k = 0; k < chart.corners.size(); ++k) {
                const glm::dvec2 p = chart.map[chart.point_of_corner[k]];
                out.uvs[mesh_of[i]][chart.corners[k]] =
                    glm::vec2(glm::clamp((place.turn * p + place.shift) / packing.side, 0.0, 1.0));
            }
            ++number;
        }
    out.facts.charts = number;
    report(progress, 1, "pack");
    measure(meshes, out);
    return out;
}

} // namespace

Unwrapped unwrapped(std::span<const UnwrapInput> meshes, const UnwrapOptions& options,
                    const Progress& progress)
{
    // One chart of millions of triangles is a system of equations that takes seconds.
    return watched([own = std::vector<UnwrapInput>(meshes.begin(), meshes.end()),
                    options](const Progress& inner) { return unwrapped_here(own, options, inner); },
                   progress);
}

} // namespace trivar
