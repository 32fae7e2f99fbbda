// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/surface.h"

#include "core/base/parallel.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace make {

namespace {

// A cell's corner c lies at (c & 1, c >> 1 & 1, c >> 2); its edges run along x, then y, then z.
constexpr int cell_edges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                   {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr int cell_faces[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                  {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};

int edge_between(int a, int b)
{
    for (int e = 0; e < 12; ++e) {
        if ((cell_edges[e][0] == a && cell_edges[e][1] == b) ||
            (cell_edges[e][0] == b && cell_edges[e][1] == a)) {
            return e;
        }
    }
    return -1;
}

struct Samples {
    vec3 origin;
    float step;
    glm::ivec3 size;
    std::vector<float> values;

    std::size_t at(int x, int y, int z) const
    {
        return std::size_t(x) +
               std::size_t(size.x) * (std::size_t(y) + std::size_t(size.y) * std::size_t(z));
    }
    vec3 position(int x, int y, int z) const { return origin + step * vec3(x, y, z); }
    bool on_rim(int x, int y, int z) const
    {
        return x == 0 || y == 0 || z == 0 || x == size.x - 1 || y == size.y - 1 || z == size.z - 1;
    }
};

Samples empty_samples(vec3 lo, vec3 hi, const Grid& grid)
{
    const float h = grid.step;
    lo -= 2.5f * h;
    hi += 2.5f * h;
    if (grid.symmetric_z) {
        const float reach = (std::ceil(std::max(-lo.z, hi.z) / h) + .5f) * h;
        lo.z = -reach;
        hi.z = reach;
    }
    const glm::ivec3 size(int((hi.x - lo.x) / h) + 2, int((hi.y - lo.y) / h) + 2,
                          int(std::lround((hi.z - lo.z) / h)) + 1);
    Samples samples{lo, h, size, {}};
    samples.values.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    return samples;
}

// Samples the field at every grid point; blocks that are far from the surface take their centre's
// value. The grid's rim counts as outside, so the surface closes there.
Samples sample(const Field& field, vec3 lo, vec3 hi, const Grid& grid)
{
    constexpr int block = 4;
    Samples s = empty_samples(lo, hi, grid);
    const auto block_row = [&](int bz, int by) {
        for (int bx = 0; bx * block < s.size.x; ++bx) {
            const vec3 center =
                s.position(bx * block, by * block, bz * block) + vec3(s.step * (block - 1) / 2.f);
            const float c = field(center).distance;
            const bool far = std::abs(c) > s.step * block * 2.4f;
            for (int z = bz * block; z < std::min(s.size.z, (bz + 1) * block); ++z) {
                for (int y = by * block; y < std::min(s.size.y, (by + 1) * block); ++y) {
                    for (int x = bx * block; x < std::min(s.size.x, (bx + 1) * block); ++x) {
                        const float v = far ? c : field(s.position(x, y, z)).distance;
                        s.values[s.at(x, y, z)] = s.on_rim(x, y, z) ? std::max(v, s.step) : v;
                    }
                }
            }
        }
    };
    const int rows = (s.size.y + block - 1) / block, slabs = (s.size.z + block - 1) / block;
    trivar::parallel_blocks(std::size_t(rows) * std::size_t(slabs), 1,
                            [&](std::size_t begin, std::size_t end) {
                                for (std::size_t i = begin; i < end; ++i) {
                                    block_row(int(i) / rows, int(i) % rows);
                                }
                            });
    return s;
}

int root_of(const std::array<int, 12>& parent, int a)
{
    while (parent[std::size_t(a)] != a) a = parent[std::size_t(a)];
    return a;
}

// Which crossed edges of a cell lie on one sheet: edges joined across the cell's faces. On a face
// with four crossings the inside corners are kept apart.
std::array<int, 12> sheets(int inside)
{
    std::array<int, 12> parent;
    std::iota(parent.begin(), parent.end(), 0);
    const auto unite = [&](int a, int b) {
        parent[std::size_t(root_of(parent, a))] = root_of(parent, b);
    };
    for (const auto& q : cell_faces) {
        int edge[4], crossed[4], n = 0;
        for (int i = 0; i < 4; ++i) {
            const int a = q[i], b = q[(i + 1) & 3];
            edge[i] = edge_between(a, b);
            if ((inside >> a & 1) != (inside >> b & 1)) crossed[n++] = i;
        }
        if (n == 2) unite(edge[crossed[0]], edge[crossed[1]]);
        for (int i = 0; n == 4 && i < 4; ++i) {
            if (inside >> q[i] & 1) unite(edge[i], edge[(i + 3) & 3]);
        }
    }
    return parent;
}

using CellPoints = std::unordered_map<std::size_t, std::array<int, 12>>; // point on each edge

// One point per sheet and cell: the mean of the sheet's crossings.
CellPoints place_points(const Samples& s, std::vector<vec3>& points)
{
    CellPoints cells;
    for (int z = 0; z + 1 < s.size.z; ++z) {
        for (int y = 0; y + 1 < s.size.y; ++y) {
            for (int x = 0; x + 1 < s.size.x; ++x) {
                float v[8];
                int inside = 0;
                for (int i = 0; i < 8; ++i) {
                    v[i] = s.values[s.at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2))];
                    inside |= int(v[i] < 0) << i;
                }
                if (inside == 0 || inside == 255) continue;
                const std::array<int, 12> parent = sheets(inside);
                std::array<int, 12> of_edge, of_sheet;
                of_edge.fill(-1);
                of_sheet.fill(-1);
                std::array<vec3, 12> sum{};
                std::array<int, 12> count{};
                for (int e = 0; e < 12; ++e) {
                    const int a = cell_edges[e][0], b = cell_edges[e][1];
                    if ((inside >> a & 1) == (inside >> b & 1)) continue;
                    const auto r = std::size_t(root_of(parent, e));
                    if (of_sheet[r] < 0) {
                        of_sheet[r] = int(points.size());
                        points.emplace_back();
                    }
                    const vec3 pa = s.position(x + (a & 1), y + (a >> 1 & 1), z + (a >> 2));
                    const vec3 pb = s.position(x + (b & 1), y + (b >> 1 & 1), z + (b >> 2));
                    sum[r] += glm::mix(pa, pb, v[a] / (v[a] - v[b]));
                    points[std::size_t(of_sheet[r])] = sum[r] / float(++count[r]);
                    of_edge[std::size_t(e)] = of_sheet[r];
                }
                cells[s.at(x, y, z)] = of_edge;
            }
        }
    }
    return cells;
}

// One quad round every crossed grid edge, from the four cells that share it.
std::vector<Face> quads(const Samples& s, const CellPoints& cells)
{
    constexpr int ring[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Face> faces;
    for (int axis = 0; axis < 3; ++axis) {
        const int o1 = (axis + 1) % 3, o2 = (axis + 2) % 3;
        const glm::ivec3 next(axis == 0, axis == 1, axis == 2);
        for (int z = 0; z + next.z < s.size.z; ++z) {
            for (int y = 0; y + next.y < s.size.y; ++y) {
                for (int x = 0; x + next.x < s.size.x; ++x) {
                    const bool a = s.values[s.at(x, y, z)] < 0;
                    if (a == (s.values[s.at(x + next.x, y + next.y, z + next.z)] < 0)) continue;
                    Face q;
                    for (int i = 0; i < 4; ++i) {
                        glm::ivec3 c(x, y, z);
                        c[o1] -= ring[i][0];
                        c[o2] -= ring[i][1];
                        const int corner = (ring[i][0] << o1) | (ring[i][1] << o2);
                        q[std::size_t(i)] = cells.at(
                            s.at(c.x, c.y,
                                 c.z))[std::size_t(edge_between(corner, corner | (1 << axis)))];
                    }
                    if (!a) std::swap(q[1], q[3]);
                    faces.push_back(q);
                }
            }
        }
    }
    return faces;
}

// Thin tips come off the grid as crumbs of a few quads; they go.
Mesh without_crumbs(const Mesh& mesh)
{
    constexpr int smallest = 40; // points
    std::vector<int> parent(mesh.points.size()), size(mesh.points.size(), 0);
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](int a) {
        while (parent[std::size_t(a)] != a) {
            parent[std::size_t(a)] = parent[std::size_t(parent[std::size_t(a)])];
            a = parent[std::size_t(a)];
        }
        return a;
    };
    for (const Face& q : mesh.faces) {
        for (int i = 1; i < 4; ++i) parent[std::size_t(find(q[std::size_t(i)]))] = find(q[0]);
    }
    for (std::size_t i = 0; i < parent.size(); ++i) ++size[std::size_t(find(int(i)))];
    Mesh kept;
    std::vector<int> to(parent.size(), -1);
    for (std::size_t i = 0; i < parent.size(); ++i) {
        if (size[std::size_t(find(int(i)))] <= smallest) continue;
        to[i] = int(kept.points.size());
        kept.points.push_back(mesh.points[i]);
    }
    for (Face q : mesh.faces) {
        if (to[std::size_t(q[0])] < 0) continue;
        for (int& i : q) i = to[std::size_t(i)];
        kept.faces.push_back(q);
    }
    return kept;
}

vec3 project(const Field& field, vec3 p, float step, int times)
{
    const float e = step * .25f;
    const auto d = [&](vec3 q) { return field(q).distance; };
    for (int i = 0; i < times; ++i) {
        const vec3 k(d(p + vec3(e, 0, 0)) - d(p - vec3(e, 0, 0)),
                     d(p + vec3(0, e, 0)) - d(p - vec3(0, e, 0)),
                     d(p + vec3(0, 0, e)) - d(p - vec3(0, 0, e)));
        const float l = glm::dot(k, k);
        if (l < 1e-12f) break;
        vec3 s = k * (d(p) * 2 * e / l);
        const float length = glm::length(s), longest = step * .6f;
        if (length > longest) s *= longest / length;
        p -= s;
    }
    return p;
}

// Evens the quads out along the surface and puts every point back on it.
void relax(const Field& field, const Grid& grid, Mesh& mesh)
{
    const std::size_t n = mesh.points.size();
    std::vector<std::vector<int>> neighbours(n);
    for (const Face& q : mesh.faces) {
        for (std::size_t i = 0; i < 4; ++i) {
            neighbours[std::size_t(q[i])].push_back(q[(i + 1) & 3]);
            neighbours[std::size_t(q[i])].push_back(q[(i + 3) & 3]);
        }
    }
    for (int round = 0; round < grid.relax; ++round) {
        const std::vector<vec3> normal = normals(mesh);
        const bool last = round + 1 == grid.relax;
        std::vector<vec3> moved(n);
        trivar::parallel_blocks(n, 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                vec3 s(0);
                for (int j : neighbours[i]) s += mesh.points[std::size_t(j)];
                s = s / float(neighbours[i].size()) - mesh.points[i];
                s -= normal[i] * glm::dot(normal[i], s);
                moved[i] = mesh.points[i] + .5f * s;
                if (round % 2 || last) moved[i] = project(field, moved[i], grid.step, last ? 2 : 1);
            }
        });
        mesh.points = std::move(moved);
    }
}

bool is_manifold(const Mesh& mesh)
{
    std::unordered_map<std::uint64_t, int> uses;
    for (const Face& q : mesh.faces) {
        for (std::size_t i = 0; i < 4; ++i) {
            const auto a = std::uint64_t(q[i]), b = std::uint64_t(q[(i + 1) & 3]);
            if (++uses[a << 32 | b] > 1) return false;
        }
    }
    return true;
}

} // namespace

Mesh surface(const Field& field, vec3 lo, vec3 hi, Grid grid)
{
    // Two sheets meeting inside one grid face can share an edge; a slightly finer grid parts them.
    constexpr int attempts = 6;
    Mesh mesh;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const Samples samples = sample(field, lo, hi, grid);
        Mesh raw;
        const CellPoints cells = place_points(samples, raw.points);
        raw.faces = quads(samples, cells);
        mesh = without_crumbs(raw);
        if (is_manifold(mesh)) break;
        grid.step *= .985f;
    }
    relax(field, grid, mesh);
    return mesh.paint([&](vec3 p) { return field(p).color; });
}

} // namespace make
