// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/meshing/domain_shapes.h"

#include "core/base/rejected.h"
#include "core/meshing/manifold_cells.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_basis.h"

#include <cmath>
#include <map>
#include <random>

namespace trivar {

TriangleSurface torus(double around, double tube, int n, int m)
{
    TriangleSurface out;
    const double turn = 2 * std::acos(-1.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double u = turn * i / n, v = turn * j / m, r = around + tube * std::cos(v);
            out.positions.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
            const int k = (i + 1) % n, l = (j + 1) % m;
            out.triangles.push_back({i * m + j, k * m + j, k * m + l});
            out.triangles.push_back({i * m + j, k * m + l, i * m + l});
        }
    return out;
}

TriangleSurface sphere(int n)
{
    TriangleSurface out;
    const double half = std::acos(-1.0);
    out.positions = {{0, 0, 1}, {0, 0, -1}};
    const auto at = [n](int i, int j) { return 2 + (i - 1) * 2 * n + j % (2 * n); };
    for (int i = 1; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const double u = half * i / n, v = half * j / n;
            out.positions.push_back(
                {std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)});
            if (i == 1) out.triangles.push_back({0, at(1, j), at(1, j + 1)});
            if (i == n - 1) out.triangles.push_back({1, at(i, j + 1), at(i, j)});
            if (i == 1) continue;
            out.triangles.push_back({at(i - 1, j), at(i, j), at(i, j + 1)});
            out.triangles.push_back({at(i - 1, j), at(i, j + 1), at(i - 1, j + 1)});
        }
    return out;
}

TriangleSurface box_surface(const glm::dvec3& lo, const glm::dvec3& hi)
{
    TriangleSurface out;
    for (int n = 0; n < 8; ++n)
        out.positions.push_back(
            {(n & 1) != 0 ? hi.x : lo.x, (n & 2) != 0 ? hi.y : lo.y, (n & 4) != 0 ? hi.z : lo.z});
    const std::array<std::array<int, 4>, 6> quads{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& q : quads) {
        out.triangles.push_back({q[0], q[1], q[2]});
        out.triangles.push_back({q[0], q[2], q[3]});
    }
    return out;
}

std::string fault(const SimplexMesh<3>& mesh, int degree)
{
    try {
        check(mesh);
        check(with_clouds<3>(mesh.vertices, mesh.cells, degree));
    } catch (const Rejected& rejected) {
        return rejected.what();
    }
    if (mesh.cells.empty()) return "There are no cells.";
    std::map<std::array<int, 2>, int> edges;
    for (const auto& f : border_faces(mesh, std::vector<bool>(mesh.cells.size(), true)))
        for (const std::array<int, 2> edge :
             {std::array<int, 2>{f[0], f[1]}, {f[1], f[2]}, {f[0], f[2]}})
            ++edges[edge];
    for (const auto& [edge, count] : edges)
        if (count != 2) return "Two parts of the border meet at an edge.";
    return {};
}

double volume(const SimplexMesh<3>& mesh)
{
    double out = 0;
    for (const auto& cell : mesh.cells) {
        std::array<glm::dvec3, 4> c;
        for (std::size_t k = 0; k < 4; ++k) c[k] = mesh.vertices[static_cast<std::size_t>(cell[k])];
        out += orientation(c) / 6;
    }
    return out;
}

double sum_error(const SimplexMesh<3>& mesh, int degree, int per_cell, bool clamped)
{
    const SimplexBasis<3> basis(
        with_clouds<3>(mesh.vertices, mesh.cells, degree,
                       {.border = clamped ? CloudBorder::stacked : CloudBorder::outside}));
    std::mt19937 random(5);
    std::exponential_distribution<double> share(1);
    double worst = 0;
    std::vector<BasisValue<3>> values;
    for (const auto& cell : mesh.cells)
        for (int n = 0; n < per_cell; ++n) {
            std::array<double, 4> l;
            for (double& each : l) each = share(random);
            if (n % 2 == 1) l[static_cast<std::size_t>(n / 2) % 4] = 1e-4; // near a face
            const double all = l[0] + l[1] + l[2] + l[3];
            glm::dvec3 x(0);
            for (std::size_t k = 0; k < 4; ++k)
                x += mesh.vertices[static_cast<std::size_t>(cell[k])] * (l[k] / all);
            basis.values_at(x, false, values);
            double sum = 0;
            for (const auto& v : values) sum += v.value;
            worst = std::max(worst, std::abs(sum - 1));
        }
    return worst;
}

} // namespace trivar
