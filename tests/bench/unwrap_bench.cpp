// SPDX-License-Identifier: GPL-3.0-or-later
// Texture coordinates of 100,000 triangles, and of rough ground of as many that is laid flat as one
// chart: by us, and by the least squares conformal map of CGAL.
#include "core/mesh/primitives.h"
#include "core/unwrap/disk.h"
#include "core/unwrap/unwrap.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <benchmark/benchmark.h>

namespace trivar {
namespace {

namespace parameterization = CGAL::Surface_mesh_parameterization;

void unwrap_torus(benchmark::State& state)
{
    Mesh mesh = torus_mesh(2, 0.7, {316, 158});
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.02f * std::sin(9 * p.x) * std::sin(11 * p.y) * std::sin(13 * p.z);
    const UnwrapInput input{make_ref(std::move(mesh))};
    const auto method = static_cast<UnwrapMethod>(state.range(0));
    Unwrapped out;
    for (auto _ : state) out = unwrapped({&input, 1}, {.method = method});
    state.counters["charts"] = static_cast<double>(out.facts.charts);
    state.counters["filled"] = out.facts.filled;
    state.counters["angle"] = out.facts.angle;
    state.counters["length"] = out.facts.length;
}
BENCHMARK(unwrap_torus)->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);

Disk rough_ground()
{
    Disk disk;
    const Mesh mesh = plane_mesh({2, 2}, {223, 223});
    for (const glm::vec3& p : mesh.positions)
        disk.points.emplace_back(p.x, p.y, 0.1 * std::sin(9 * p.x) * std::sin(8 * p.y));
    disk.triangles = triangles(mesh);
    return disk;
}

void flatten_one_chart(benchmark::State& state)
{
    const Disk disk = rough_ground();
    std::vector<glm::dvec2> map;
    for (auto _ : state) map = conformal_map(disk);
    state.counters["folded"] = is_folded(disk, map);
}
BENCHMARK(flatten_one_chart)->Unit(benchmark::kMillisecond);

void flatten_by_cgal(benchmark::State& state)
{
    using Kernel = CGAL::Simple_cartesian<double>;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    const Disk disk = rough_ground();
    Surface surface;
    for (const glm::dvec3& p : disk.points) surface.add_vertex({p.x, p.y, p.z});
    for (const glm::uvec3& t : disk.triangles)
        surface.add_face(Surface::Vertex_index(t.x), Surface::Vertex_index(t.y),
                         Surface::Vertex_index(t.z));
    const auto rim = CGAL::Polygon_mesh_processing::longest_border(surface).first;
    const auto uv = surface.add_property_map<Surface::Vertex_index, Kernel::Point_2>("v:uv").first;
    for (auto _ : state)
        parameterization::parameterize(surface, parameterization::LSCM_parameterizer_3<Surface>(),
                                       rim, uv);
    std::vector<glm::dvec2> map;
    for (const auto v : surface.vertices()) map.emplace_back(uv[v].x(), uv[v].y());
    state.counters["folded"] = is_folded(disk, map);
}
BENCHMARK(flatten_by_cgal)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
