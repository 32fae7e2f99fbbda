// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_basis.h"

#include "core/simplex/cell_faces.h"
#include "core/simplex/exact_side.h"
#include "core/simplex/fibre.h"
#include "core/simplex/precise_volume.h"
#include "core/simplex/shared_points.h"

#include <algorithm>

namespace trivar {
namespace {

// Coordinates so near 0 and 1 are exactly that: knots in the plane of a face and on vertices.
constexpr double coincident = 1e-9;
// Barycentric distance from a plane below which its side is told exactly.
constexpr double near_plane = 1e-10;
// The growth of rounding from which a cell counts as steep. A cell of a box has about 100.
constexpr double steep_growth = 1000;
constexpr std::array<double, 3> generic_direction{0.7548776662466927, 0.5698402909980532,
                                                  0.3247179572447460};

double factorial(int n)
{
    return n == 3 ? 6 : n;
}

double tidied(double coordinate)
{
    if (std::abs(coordinate) < coincident) return 0;
    return std::abs(coordinate - 1) < coincident ? 1 : coordinate;
}

// Longest edge over the least height.
template <class Corners> double slimness(const Corners& corners, const Corners& gradients)
{
    double longest = 0, steepest = 0;
    for (const auto& a : corners)
        for (const auto& b : corners) longest = std::max(longest, glm::distance(a, b));
    for (const auto& each : gradients) steepest = std::max(steepest, glm::length(each));
    return longest * steepest;
}

template <class Corners, class Point>
auto precise_barycentric(const Corners& corners, const Point& x)
{
    std::array<double, std::tuple_size_v<Corners>> out;
    for (std::size_t k = 0; k < out.size(); ++k) {
        Corners part = corners;
        part[k] = x;
        out[k] = volume_ratio(part, corners);
    }
    return out;
}

// The gradients of all barycentric coordinates.
std::array<glm::dvec2, 3> gradients(const std::array<glm::dvec2, 3>& c)
{
    const glm::dmat2 inverse = glm::inverse(glm::transpose(glm::dmat2(c[1] - c[0], c[2] - c[0])));
    return {-inverse[0] - inverse[1], inverse[0], inverse[1]};
}
std::array<glm::dvec3, 4> gradients(const std::array<glm::dvec3, 4>& c)
{
    const glm::dmat3 inverse =
        glm::inverse(glm::transpose(glm::dmat3(c[1] - c[0], c[2] - c[0], c[3] - c[0])));
    return {-inverse[0] - inverse[1] - inverse[2], inverse[0], inverse[1], inverse[2]};
}

} // namespace

template <int S>
SimplexBasis<S>::SimplexBasis(SimplexDomain<S> domain)
    : domain_(std::move(domain)),
      per_cell_(multi_indices<S>(domain_.degree).size())
{
    const auto indices = multi_indices<S>(domain_.degree);
    std::vector<CellBox<S>> boxes;
    for (std::size_t c = 0; c < domain_.cells.size(); ++c) {
        const auto corner = corners(domain_, c);
        cells_.push_back({corner[0], gradients(corner), {}});
        CellData& cell = cells_.back();
        cell.least.fill(0);
        double nearest = 1; // of all cloud knots to planes of faces through their vertex
        for (std::size_t k = 0; k < K; ++k)
            for (int j = 1; j <= domain_.degree; ++j) {
                const Barycentric l = barycentric(c, domain_.knot(domain_.cells[c][k], j));
                for (std::size_t i = 0; i < K; ++i)
                    if (i != k && tidied(l[i]) != 0) nearest = std::min(nearest, std::abs(l[i]));
            }
        cell.steep = !(slimness(corner, cell.gradient) < steep_growth * nearest);
        CellBox<S> box{corner[0], corner[0]};
        for (std::size_t k = 0; k < K; ++k)
            for (int j = 0; j <= domain_.degree; ++j) {
                const Point& knot = domain_.knot(domain_.cells[c][k], j);
                box = {glm::min(box.lo, knot), glm::max(box.hi, knot)};
                if (j == 0) continue;
                Barycentric l = barycentric(c, knot);
                for (std::size_t i = 0; i < K; ++i) {
                    l[i] = tidied(l[i]);
                    cell.least[i] = std::min(cell.least[i], l[i]);
                }
                clouds_.push_back(l);
            }
        for (const MultiIndex<S>& b : indices) {
            auto x = corner;
            for (std::size_t k = 0; k < K; ++k) x[k] = domain_.knot(domain_.cells[c][k], b[k]);
            const double share =
                cell.steep ? volume_ratio(x, corner) : orientation(x) / orientation(corner);
            scales_.push_back(factorial(domain_.degree) * std::abs(share));
            std::uint8_t jumps = 0;
            for (std::size_t i = 0; i < K; ++i) {
                bool in_plane = b[i] == 0;
                for (std::size_t k = 0; k < K; ++k)
                    for (int j = 1; j <= b[k]; ++j)
                        in_plane = in_plane &&
                                   clouds_[(c * K + k) * static_cast<std::size_t>(domain_.degree) +
                                           static_cast<std::size_t>(j - 1)][i] == 0;
                if (in_plane) jumps = static_cast<std::uint8_t>(jumps | 1U << i);
            }
            jumps_.push_back(jumps);
        }
        // a little more, as rounding may put a knot of one cell outside of its own box
        const Point more = (box.hi - box.lo) * 1e-12;
        boxes.push_back({box.lo - more, box.hi + more});
    }
    grid_ = BoxGrid<S>(boxes);
    points_ = shared_points(domain_);
    find_points();
    find_border();
}

template <int S> void SimplexBasis<S>::find_points()
{
    const auto indices = multi_indices<S>(domain_.degree);
    rest_.resize(points_.empty() ? 0
                                 : static_cast<std::size_t>(
                                       *std::max_element(points_.begin(), points_.end()) + 1));
    for (std::size_t c = 0; c < domain_.cells.size(); ++c)
        for (std::size_t i = 0; i < per_cell_; ++i) {
            Point sum(0);
            for (std::size_t k = 0; k < K; ++k)
                for (int j = 0; j < indices[i][k]; ++j) sum += domain_.knot(domain_.cells[c][k], j);
            rest_[static_cast<std::size_t>(point_of(c, i))] =
                sum / static_cast<double>(domain_.degree);
        }
}

template <int S>
auto SimplexBasis<S>::barycentric(std::size_t number, const Point& x) const -> Barycentric
{
    const CellData& cell = cells_[number];
    if (cell.steep) return precise_barycentric(corners(domain_, number), x);
    Barycentric l;
    const Point d = x - cell.origin;
    l[0] = 1;
    for (std::size_t k = 1; k < K; ++k) {
        l[k] = glm::dot(cell.gradient[k], d);
        l[0] -= l[k];
    }
    return l;
}

template <int S> void SimplexBasis<S>::find_border()
{
    const std::vector<CellFace<S>> faces = sorted_faces(domain_);
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (f + 1 < faces.size() && faces[f].vertices == faces[f + 1].vertices)
            ++f;
        else
            cells_[faces[f].cell].border =
                static_cast<std::uint8_t>(cells_[faces[f].cell].border | 1U << faces[f].opposite);
}

// The fixed direction, which lies in no plane that anyone is likely to draw; on the border of the
// domain, the one into a cell.
template <int S> auto SimplexBasis<S>::inner_direction(const Point& x) const -> Point
{
    for (const std::int32_t number : grid_.boxes_at(x)) {
        const auto c = static_cast<std::size_t>(number);
        if (cells_[c].border == 0) continue;
        const Barycentric l = barycentric(c, x);
        bool inside = true, on_border = false;
        for (std::size_t k = 0; k < K; ++k) {
            inside = inside && l[k] > -near_plane;
            on_border = on_border || ((cells_[c].border >> k & 1U) != 0 && l[k] < near_plane);
        }
        if (!inside || !on_border) continue;
        Point middle(0);
        for (const Point& corner : corners(domain_, c)) middle += corner;
        return glm::normalize(middle / static_cast<double>(K) - x);
    }
    Point out;
    for (int i = 0; i < S; ++i) out[i] = generic_direction[static_cast<std::size_t>(i)];
    return out;
}

// Whether a place lies beyond the face opposite to a corner. The border lies inside.
template <int S>
bool SimplexBasis<S>::beyond_jump(std::size_t cell, std::size_t corner, const Place& at) const
{
    if ((cells_[cell].border >> corner & 1U) != 0) return false;
    std::array<Point, S> face;
    std::array<int, S> numbers;
    for (std::size_t k = 0, n = 0; k < K; ++k)
        if (k != corner) {
            numbers[n] = domain_.cells[cell][k];
            face[n++] = domain_.vertex(domain_.cells[cell][k]);
        }
    return exact_side(face, numbers, at.x, at.direction) !=
           exact_side(face, numbers, domain_.vertex(domain_.cells[cell][corner]), at.direction);
}

template <int S>
template <int N>
bool SimplexBasis<S>::add_values(std::size_t cell, const Barycentric& l, const Place& place,
                                 std::vector<BasisValue<S>>& out) const
{
    const auto indices = multi_indices<S>(N);
    const Barycentric* const clouds = &clouds_[cell * K * N];
    bool on_edge = false;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t function = cell * per_cell_ + i;
        Barycentric at = l;
        bool outside = false;
        if (jumps_[function] != 0)
            for (std::size_t k = 0; k < K; ++k) {
                if ((jumps_[function] >> k & 1U) == 0) continue;
                if (std::abs(l[k]) < near_plane) {
                    outside = outside || beyond_jump(cell, k, place);
                    at[k] = std::max(at[k], 0.0);
                } else
                    outside = outside || l[k] < 0;
            }
        if (outside) continue;
        std::array<glm::vec<N, double>, K> rows;
        for (int column = 0, corner = 0, j = 0; column < N; ++column, ++j) {
            while (j >= indices[i][static_cast<std::size_t>(corner)]) ++corner, j = 0;
            const Barycentric& knot = clouds[corner * N + j];
            for (std::size_t k = 0; k < K; ++k) rows[k][column] = knot[k];
        }
        const FibreVolume<K> fibre = fibre_volume<N, S + 1>(at, rows, place.gradients);
        on_edge = on_edge || fibre.on_edge;
        if (fibre.volume <= 0) continue;
        BasisValue<S> value{points_[function], fibre.volume * scales_[function], Point(0)};
        if (place.gradients)
            for (std::size_t k = 0; k < K; ++k)
                value.gradient += cells_[cell].gradient[k] * (fibre.facet[k] * scales_[function]);
        out.push_back(value);
    }
    return on_edge;
}

template <int S>
bool SimplexBasis<S>::add_all(const Place& at, std::vector<BasisValue<S>>& out) const
{
    bool on_edge = false;
    for (const std::int32_t number : grid_.boxes_at(at.x)) {
        const auto c = static_cast<std::size_t>(number);
        const Barycentric l = barycentric(c, at.x);
        bool near = true;
        for (std::size_t k = 0; k < K; ++k) near = near && l[k] >= cells_[c].least[k] - 1e-12;
        if (!near) continue;
        bool jumps = false;
        if (domain_.degree == 1)
            jumps = add_values<1>(c, l, at, out);
        else if (domain_.degree == 2)
            jumps = add_values<2>(c, l, at, out);
        else
            jumps = add_values<3>(c, l, at, out);
        on_edge = on_edge || jumps;
    }
    return on_edge;
}

template <int S>
void SimplexBasis<S>::values_at(const Point& x, bool gradients,
                                std::vector<BasisValue<S>>& out) const
{
    out.clear();
    const Point direction = inner_direction(x);
    if (!add_all({x, direction, gradients}, out)) return;
    // At a jump all functions use the gradient of the same side.
    const auto& cell = cells_[static_cast<std::size_t>(grid_.boxes_at(x)[0])];
    const double step = 1e-8 / glm::length(cell.gradient[1]);
    std::vector<BasisValue<S>> aside;
    add_all({x + direction * step, direction, true}, aside);
    for (BasisValue<S>& each : aside) each.value = 0;
    for (BasisValue<S>& each : out) each.gradient = Point(0);
    out.insert(out.end(), aside.begin(), aside.end());
}

template class SimplexBasis<2>;
template class SimplexBasis<3>;

} // namespace trivar
