// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/disk.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>

namespace trivar {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// A FlatTriangle is a triangle laid into the plane: its first corner at 0, the second on the x
// axis.
struct FlatTriangle {
    glm::dvec2 corners[3];
    double cotangent(std::size_t corner) const
    {
        const glm::dvec2 a = corners[(corner + 1) % 3] - corners[corner],
                         b = corners[(corner + 2) % 3] - corners[corner];
        return glm::dot(a, b) / (a.x * b.y - a.y * b.x);
    }
};

// Lays triangles flat by the lengths of their edges, which are all made longer by the amount that
// the flattest triangle needs.
std::vector<FlatTriangle> flat_triangles(const Disk& disk)
{
    std::vector<glm::dvec3> lengths; // of the side behind each corner
    double sum = 0;
    for (const glm::uvec3& t : disk.triangles) {
        glm::dvec3 l;
        for (int k = 0; k < 3; ++k)
            l[k] = glm::distance(disk.points[t[(k + 1) % 3]], disk.points[t[(k + 2) % 3]]);
        lengths.push_back(l);
        sum += l.x + l.y + l.z;
    }
    const double least = 1e-5 * sum / static_cast<double>(3 * lengths.size()) + 1e-300;
    double longer = 0;
    for (const glm::dvec3& l : lengths)
        for (int k = 0; k < 3; ++k)
            longer = std::max(longer, least + l[k] - l[(k + 1) % 3] - l[(k + 2) % 3]);
    std::vector<FlatTriangle> out;
    for (const glm::dvec3& given : lengths) {
        const glm::dvec3 l = given + longer;
        const double x = (l.z * l.z + l.y * l.y - l.x * l.x) / (2 * l.z);
        // Heron's formula as Kahan writes it keeps its digits in thin triangles.
        glm::dvec3 s = l;
        std::sort(&s.x, &s.x + 3, std::greater<>());
        const double root =
            (s.x + (s.y + s.z)) * (s.z - (s.x - s.y)) * (s.z + (s.x - s.y)) * (s.x + (s.y - s.z));
        out.push_back({{{0, 0}, {l.z, 0}, {x, std::sqrt(std::max(0.0, root)) / (2 * l.z)}}});
    }
    return out;
}

// The weights of the cotangents: 1/2 sum of w_ij |u_i - u_j|^2 is the Dirichlet energy.
Entries cotangent_entries(const Disk& disk, const std::vector<FlatTriangle>& flat)
{
    Entries out;
    for (std::size_t t = 0; t < flat.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::uvec3& corners = disk.triangles[t];
            const int i = static_cast<int>(corners[static_cast<int>((k + 1) % 3)]),
                      j = static_cast<int>(corners[static_cast<int>((k + 2) % 3)]);
            const double w = flat[t].cotangent(k) / 2;
            out.insert(out.end(), {{i, i, w}, {j, j, w}, {i, j, -w}, {j, i, -w}});
        }
    return out;
}

std::uint32_t farthest(const Disk& disk, const std::vector<std::uint32_t>& of, std::uint32_t from)
{
    return *std::ranges::max_element(
        of, {}, [&](std::uint32_t p) { return glm::distance(disk.points[p], disk.points[from]); });
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

bool meets_itself(const std::vector<glm::dvec2>& rim)
{
    // Edges in the order of their left ends, so that each is compared with those above it only.
    const std::size_t n = rim.size();
    std::vector<std::size_t> order(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = k;
    const auto low = [&](std::size_t k) { return glm::min(rim[k], rim[(k + 1) % n]); };
    const auto high = [&](std::size_t k) { return glm::max(rim[k], rim[(k + 1) % n]); };
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::pair(low(a).x, a) < std::pair(low(b).x, b);
    });
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n && low(order[j]).x <= high(order[i]).x; ++j) {
            const std::size_t a = order[i], b = order[j];
            if ((a + 1) % n == b || (b + 1) % n == a) continue;
            if (low(a).y > high(b).y || low(b).y > high(a).y) continue;
            if (meet(rim[a], rim[(a + 1) % n], rim[b], rim[(b + 1) % n])) return true;
        }
    return false;
}

} // namespace

std::vector<std::uint32_t> rim_of(const Disk& disk)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides; // both ways
    for (const glm::uvec3& t : disk.triangles)
        for (int k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
    std::ranges::sort(sides);
    std::vector<std::uint32_t> next(disk.points.size()), out;
    std::uint32_t first = 0;
    for (const auto& [a, b] : sides)
        if (!std::ranges::binary_search(sides, std::pair(b, a))) {
            next[a] = b;
            first = a;
        }
    std::uint32_t p = first;
    do {
        out.push_back(p);
        p = next[p];
    } while (p != first && out.size() <= disk.points.size());
    return out;
}

std::vector<glm::dvec2> conformal_map(const Disk& disk)
{
    const std::vector<std::uint32_t> rim = rim_of(disk);
    const std::uint32_t one = farthest(disk, rim, rim.front()), two = farthest(disk, rim, one);
    const int n = static_cast<int>(disk.points.size());
    // Unknowns: all x, then all y, without those of the two points that are held.
    std::vector<int> unknown(disk.points.size(), -1);
    int count = 0;
    for (std::uint32_t p = 0; p < disk.points.size(); ++p)
        if (p != one && p != two) unknown[p] = count++;
    const auto index = [&](int row) {
        const int k = unknown[static_cast<std::size_t>(row % n)];
        return k < 0 ? -1 : k + (row < n ? 0 : count);
    };
    Entries all;
    for (const auto& e : cotangent_entries(disk, flat_triangles(disk)))
        for (const int shift : {0, n})
            all.emplace_back(e.row() + shift, e.col() + shift, e.value());
    for (std::size_t k = 0; k < rim.size(); ++k) { // the area, x_i y_j - x_j y_i over the rim
        const int i = static_cast<int>(rim[k]), j = static_cast<int>(rim[(k + 1) % rim.size()]);
        for (const auto& [row, column, value] :
             {std::tuple(i, j + n, -0.5), std::tuple(j, i + n, 0.5)}) {
            all.emplace_back(row, column, value);
            all.emplace_back(column, row, value);
        }
    }
    const double apart = glm::distance(disk.points[one], disk.points[two]);
    std::vector<glm::dvec2> map(disk.points.size(), glm::dvec2(0));
    map[two].x = apart > 0 ? apart : 1;
    Entries inner;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count);
    for (const auto& e : all) {
        const int row = index(e.row()), column = index(e.col());
        if (row < 0) continue;
        if (column >= 0) inner.emplace_back(row, column, e.value());
        // Only one coordinate of the held vertices is not 0.
        else if (e.col() == static_cast<int>(two))
            right[row] -= e.value() * map[two].x;
    }
    if (count == 0) return map;
    SparseMatrix matrix(2 * count, 2 * count);
    matrix.setFromTriplets(inner.begin(), inner.end());
    const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
    if (solver.info() != Eigen::Success) return map; // folded, and is found to be
    const Eigen::VectorXd solution = solver.solve(right);
    for (std::size_t p = 0; p < map.size(); ++p)
        if (unknown[p] >= 0) map[p] = {solution[unknown[p]], solution[unknown[p] + count]};
    return map;
}

std::vector<glm::dvec2> rigid_map(const Disk& disk, std::vector<glm::dvec2> start, int rounds)
{
    const std::vector<FlatTriangle> flat = flat_triangles(disk);
    const int n = static_cast<int>(disk.points.size());
    SparseMatrix matrix(n - 1, n - 1); // the last point stays where it is
    Entries inner;
    for (const auto& e : cotangent_entries(disk, flat))
        if (e.row() < n - 1 && e.col() < n - 1) inner.push_back(e);
    matrix.setFromTriplets(inner.begin(), inner.end());
    const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
    if (solver.info() != Eigen::Success) return start;
    std::vector<glm::dvec2> map = std::move(start);
    const glm::dvec2 held = map.back();
    for (int round = 0; round < rounds; ++round) {
        Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
        for (std::size_t t = 0; t < flat.size(); ++t) {
            const glm::uvec3& c = disk.triangles[t];
            double cosine = 0, sine = 0; // of the best rotation, times a factor
            for (int k = 0; k < 3; ++k) {
                const int a = (k + 1) % 3, b = (k + 2) % 3;
                const double w = flat[t].cotangent(static_cast<std::size_t>(k));
                const glm::dvec2 x = flat[t].corners[a] - flat[t].corners[b],
                                 u = map[c[a]] - map[c[b]];
                cosine += w * glm::dot(x, u);
                sine += w * (x.x * u.y - x.y * u.x);
            }
            const double size = std::hypot(cosine, sine);
            if (size > 0)
                cosine /= size, sine /= size;
            else
                cosine = 1, sine = 0;
            for (int k = 0; k < 3; ++k) {
                const int a = (k + 1) % 3, b = (k + 2) % 3;
                const double w = flat[t].cotangent(static_cast<std::size_t>(k)) / 2;
                const glm::dvec2 x = flat[t].corners[a] - flat[t].corners[b];
                const Eigen::RowVector2d turned(w * (cosine * x.x - sine * x.y),
                                                w * (sine * x.x + cosine * x.y));
                right.row(static_cast<int>(c[a])) += turned;
                right.row(static_cast<int>(c[b])) -= turned;
            }
        }
        const Eigen::MatrixX2d solution = solver.solve(right.topRows(n - 1));
        for (int p = 0; p < n - 1; ++p)
            map[static_cast<std::size_t>(p)] = held + glm::dvec2(solution(p, 0), solution(p, 1));
    }
    return map;
}

std::vector<glm::dvec2> circle_map(const Disk& disk)
{
    const std::vector<std::uint32_t> rim = rim_of(disk);
    std::vector<double> before; // length of the rim from its first point to each
    double length = 0;
    const auto edge = [&](std::size_t k) {
        return glm::distance(disk.points[rim[k]], disk.points[rim[(k + 1) % rim.size()]]);
    };
    double whole = 0;
    for (std::size_t k = 0; k < rim.size(); ++k) whole += edge(k);
    const double least = whole > 0 ? 1e-3 * whole / static_cast<double>(rim.size()) : 1;
    for (std::size_t k = 0; k < rim.size(); ++k) {
        before.push_back(length);
        length += std::max(edge(k), least);
    }
    std::vector<glm::dvec2> map(disk.points.size(), glm::dvec2(0));
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const double angle = glm::two_pi<double>() * before[k] / length;
        map[rim[k]] = length * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    return map;
}

bool is_folded(const Disk& disk, std::span<const glm::dvec2> map)
{
    for (const glm::uvec3& t : disk.triangles)
        if (!(turn(map[t.x], map[t.y], map[t.z]) > 0)) return true;
    std::vector<glm::dvec2> rim;
    for (const std::uint32_t p : rim_of(disk)) rim.push_back(map[p]);
    return meets_itself(rim);
}

} // namespace trivar
