// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplex/degenerate_domains.h"

#include "core/base/rejected.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/clouds.h"
#include "core/simplex/multi_index.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double vertex_grain = 0x1p-10, knot_grain = 0x1p-34;

int whole(std::mt19937& random, int from, int to) // both included; the same on every machine
{
    return from + static_cast<int>(random() % static_cast<std::uint32_t>(to - from + 1));
}
double between(std::mt19937& random, double lo, double hi)
{
    return lo + (hi - lo) * (static_cast<double>(random()) * 0x1p-32);
}
template <int S> glm::vec<S, double> in_box(std::mt19937& random, double most, double grain)
{
    glm::vec<S, double> out;
    for (int i = 0; i < S; ++i) out[i] = std::round(between(random, -most, most) / grain) * grain;
    return out;
}

SimplexMesh<2> boxes(const glm::ivec2& count)
{
    return rectangle_cells(glm::dvec2(2), count);
}
SimplexMesh<3> boxes(const glm::ivec3& count)
{
    return box_cells(glm::dvec3(2), count);
}

template <int S> double flatness(const std::array<glm::vec<S, double>, S + 1>& corners)
{
    double longest = 0;
    for (const auto& a : corners)
        for (const auto& b : corners) longest = std::max(longest, glm::distance(a, b));
    return orientation(corners) / std::pow(longest, S);
}

template <int S> SimplexMesh<S> one_cell(std::mt19937& random)
{
    SimplexMesh<S> out;
    for (;;) {
        std::array<glm::vec<S, double>, S + 1> corners;
        for (auto& each : corners) each = in_box<S>(random, 1, vertex_grain);
        if (!(flatness<S>(corners) > 0.02)) continue;
        out.vertices.assign(corners.begin(), corners.end());
        std::array<int, S + 1> cell;
        for (int k = 0; k <= S; ++k) cell[static_cast<std::size_t>(k)] = k;
        out.cells = {cell};
        return out;
    }
}

// The first cell is parted at a point that may be as near to a face as 2^-12 of the cell.
template <int S> void part_at_a_point(SimplexMesh<S>& mesh, std::mt19937& random)
{
    const std::array<int, S + 1> cell = mesh.cells[0];
    std::array<double, S + 1> l{};
    const double least = std::exp2(-whole(random, 2, 12));
    l[0] = least;
    double rest = 1 - least;
    for (std::size_t k = 1; k < S; ++k) {
        l[k] = rest * whole(random, 1, 3) / 8;
        rest -= l[k];
    }
    l[S] = rest;
    std::rotate(l.begin(), l.begin() + whole(random, 0, S), l.end());
    glm::vec<S, double> at(0);
    for (std::size_t k = 0; k <= S; ++k)
        at += mesh.vertices[static_cast<std::size_t>(cell[k])] * l[k];
    const int number = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(at);
    for (std::size_t k = 0; k <= S; ++k) {
        std::array<int, S + 1> part = cell;
        part[k] = number;
        if (k == 0)
            mesh.cells[0] = part;
        else
            mesh.cells.push_back(part);
    }
}

// Halves of axes, then shears: exact.
template <int S> void squeeze(SimplexMesh<S>& mesh, std::mt19937& random)
{
    const int axis = whole(random, 0, S - 1);
    const double factor = std::exp2(-whole(random, 0, 10));
    const int other = (axis + whole(random, 1, S - 1)) % S;
    const double shear = whole(random, -8, 8) / 8.0;
    for (auto& v : mesh.vertices) {
        v[axis] *= factor;
        v[other] += shear * v[axis];
    }
}

template <int S> double least_share_at(const SimplexDomain<S>& domain, int vertex)
{
    double least = 1;
    for (std::size_t c = 0; c < domain.cells.size(); ++c) {
        const auto& cell = domain.cells[c];
        if (vertex >= 0 && std::find(cell.begin(), cell.end(), vertex) == cell.end()) continue;
        const double all = orientation(corners(domain, c));
        for (const MultiIndex<S>& index : multi_indices<S>(domain.degree)) {
            auto x = corners(domain, c);
            for (std::size_t k = 0; k <= S; ++k) x[k] = domain.knot(cell[k], index[k]);
            least = std::min(least, orientation(x) / all);
        }
    }
    return least;
}

template <int S> std::vector<bool> on_border(const SimplexDomain<S>& domain)
{
    std::vector<bool> out(domain.vertex_count(), false);
    const auto faces = sorted_faces(domain);
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (f + 1 < faces.size() && faces[f].vertices == faces[f + 1].vertices)
            ++f;
        else
            for (const int v : faces[f].vertices) out[static_cast<std::size_t>(v)] = true;
    return out;
}

// Knots of one vertex as special ones. Those on the border go away from other vertices: in a
// convex domain that is outside or along it.
template <int S>
void put_cloud(SimplexDomain<S>& domain, int vertex, bool border, std::mt19937& random)
{
    const auto& cell = [&]() -> const std::array<int, S + 1>& {
        std::vector<std::size_t> round;
        for (std::size_t c = 0; c < domain.cells.size(); ++c)
            if (std::count(domain.cells[c].begin(), domain.cells[c].end(), vertex) > 0)
                round.push_back(c);
        return domain.cells[round[random() % round.size()]];
    }();
    std::vector<int> others;
    for (const int v : cell)
        if (v != vertex) others.push_back(v);
    const int kind = whole(random, 0, 4);
    const auto knot = [&](int j) -> auto&
    {
        return domain.knots[static_cast<std::size_t>(vertex * domain.knots_per_vertex() + j)];
    };
    const auto at = domain.vertex(vertex);
    const double step = std::exp2(-whole(random, 3, 6));
    const int stacked = whole(random, 1, domain.degree);
    for (int j = 1; j <= domain.degree; ++j) {
        const double sign = border || whole(random, 0, 1) == 0 ? -1 : 1;
        if (kind == 0) knot(j) = at; // all on the vertex
        if (kind == 1 && j == stacked) knot(j) = at;
        if (kind == 2) knot(j) = knot(1); // all at one place
        if (kind == 3)                    // on the line of an edge
            knot(j) = at + sign * step * (domain.vertex(others[random() % others.size()]) - at);
        if (kind == 4) { // in the plane of a face
            knot(j) = at;
            for (std::size_t i = 0; i + 1 < others.size(); ++i)
                knot(j) +=
                    sign * step * (whole(random, 0, 4) / 4.0) * (domain.vertex(others[i]) - at);
        }
    }
}

} // namespace

template <int S>
DegenerateDomain<S> degenerate_domain(int degree, double least_share, std::mt19937& random)
{
    for (;;) {
        SimplexMesh<S> mesh;
        const int shape = whole(random, 0, 2);
        if (shape < 2)
            mesh = one_cell<S>(random);
        else {
            glm::vec<S, int> count(1);
            count[0] = whole(random, 1, 2);
            if (S == 2) count[1] = whole(random, 1, 2);
            mesh = boxes(count);
        }
        if (shape == 1) part_at_a_point(mesh, random);
        squeeze(mesh, random);
        DegenerateDomain<S> out{{},
                                shape == 0   ? "one cell"
                                : shape == 1 ? "a parted cell"
                                             : "boxes"};
        for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
            std::array<glm::vec<S, double>, S + 1> corner;
            for (std::size_t k = 0; k <= S; ++k)
                corner[k] = mesh.vertices[static_cast<std::size_t>(mesh.cells[c][k])];
            out.flatness = std::min(out.flatness, flatness<S>(corner));
        }
        const bool stacked = whole(random, 0, 3) == 0;
        out.domain =
            with_clouds<S>(mesh.vertices, mesh.cells, degree,
                           {.spread = between(random, 0.02, 0.3),
                            .border = stacked ? CloudBorder::stacked : CloudBorder::outside});
        for (auto& knot : out.domain.knots)
            for (int i = 0; i < S; ++i) knot[i] = std::round(knot[i] / knot_grain) * knot_grain;
        if (!(least_share_at(out.domain, -1) >= std::min(least_share, 0.15))) continue;
        const std::vector<bool> border = on_border(out.domain);
        for (int v = 0; v < static_cast<int>(border.size()); ++v) {
            if (whole(random, 0, 1) == 0) continue;
            const std::vector<glm::vec<S, double>> before = out.domain.knots;
            put_cloud(out.domain, v, border[static_cast<std::size_t>(v)], random);
            if (!(least_share_at(out.domain, v) >= least_share)) out.domain.knots = before;
        }
        try {
            check(out.domain);
        } catch (const Rejected&) {
            continue;
        }
        return out;
    }
}

template <int S>
glm::vec<S, double> special_point(const SimplexDomain<S>& domain, PointKind kind,
                                  std::mt19937& random)
{
    using Point = glm::vec<S, double>;
    const auto& cell = domain.cells[random() % domain.cells.size()];
    std::vector<Point> span; // of which the point is a mean
    const auto random_knot = [&](int v) { return domain.knot(v, whole(random, 0, domain.degree)); };
    std::array<int, S + 1> order = cell;
    for (std::size_t k = S; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
    const int count = kind == PointKind::on_vertex || kind == PointKind::on_knot ? 1
                      : kind == PointKind::on_edge                               ? 2
                      : kind == PointKind::anywhere                              ? S + 1
                      : kind == PointKind::on_knot_plane ? whole(random, 2, S)
                                                         : S;
    const bool knots = kind == PointKind::on_knot || kind == PointKind::on_knot_plane;
    for (int k = 0; k < count; ++k) {
        const int v = order[static_cast<std::size_t>(knots && whole(random, 0, 3) == 0 ? 0 : k)];
        span.push_back(knots ? random_knot(v) : domain.vertex(v));
    }
    const int parts = 64;
    Point out(0);
    if (kind == PointKind::anywhere) {
        double sum = 0;
        for (const Point& each : span) {
            const double share = -std::log(between(random, 1e-9, 1));
            out += each * share;
            sum += share;
        }
        return out / sum;
    }
    int left = parts;
    for (std::size_t k = 0; k + 1 < span.size(); ++k) {
        const int share = whole(random, 0, left);
        out += span[k] * (static_cast<double>(share) / parts);
        left -= share;
    }
    out += span.back() * (static_cast<double>(left) / parts);
    if (kind != PointKind::beside) return out;
    Point middle(0);
    for (const int v : cell) middle += domain.vertex(v);
    return out + (middle / static_cast<double>(S + 1) - out) * std::exp2(-whole(random, 20, 52));
}

template DegenerateDomain<2> degenerate_domain(int, double, std::mt19937&);
template DegenerateDomain<3> degenerate_domain(int, double, std::mt19937&);
template glm::dvec2 special_point(const SimplexDomain<2>&, PointKind, std::mt19937&);
template glm::dvec3 special_point(const SimplexDomain<3>&, PointKind, std::mt19937&);

} // namespace trivar
