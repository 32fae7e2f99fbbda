// SPDX-License-Identifier: GPL-3.0-or-later
// A million triangles from an OBJ file with positions, normals and texture coordinates, against
// OpenMesh's reader of the same file, and from an STL file, which has no normals.
#include "core/base/parallel.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "tests/support/fixtures.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <benchmark/benchmark.h>

namespace trivar {
namespace {

// Written once for all measurements: 1000 x 500 quads cut to a million triangles.
struct MillionTriangles {
    testing::TemporaryFolder folder;
    std::string path = folder.file("million.obj"), facets = folder.file("million.stl");

    MillionTriangles()
    {
        Mesh torus = torus_mesh(2, 0.7, {1000, 500});
        const std::vector<glm::uvec3> cut = triangles(torus);
        torus.corners.clear();
        torus.face_begin = {0};
        for (const glm::uvec3& t : cut) add_face(torus, std::array{t.x, t.y, t.z});
        const Model model = single_mesh_model("torus", std::move(torus));
        write_model(model, path);
        write_model(model, facets);
    }
};

const MillionTriangles& million_triangles()
{
    static const MillionTriangles file;
    return file;
}

void import_model(benchmark::State& state, const std::string& path)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    std::size_t faces = 0, vertices = 0;
    for (auto _ : state) {
        const Ref<Mesh> mesh = read_model(path).meshes[0];
        faces = mesh->face_count();
        vertices = mesh->vertex_count();
    }
    state.counters["triangles"] = static_cast<double>(faces);
    state.counters["vertices"] = static_cast<double>(vertices);
}

void import_million_triangles(benchmark::State& state)
{
    import_model(state, million_triangles().path);
}
BENCHMARK(import_million_triangles)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void import_million_facets(benchmark::State& state)
{
    import_model(state, million_triangles().facets);
}
BENCHMARK(import_million_facets)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void import_million_triangles_by_openmesh(benchmark::State& state)
{
    const std::string& path = million_triangles().path;
    std::size_t faces = 0;
    for (auto _ : state) {
        OpenMesh::TriMesh_ArrayKernelT<> mesh;
        mesh.request_vertex_normals();
        mesh.request_vertex_texcoords2D();
        OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexNormal |
                                      OpenMesh::IO::Options::VertexTexCoord);
        if (!OpenMesh::IO::read_mesh(mesh, path, options)) state.SkipWithError("not read");
        faces = mesh.n_faces();
    }
    state.counters["triangles"] = static_cast<double>(faces);
}
BENCHMARK(import_million_triangles_by_openmesh)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
