// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/error_bounds.h"

#include "core/refinement/net_bisection.h"
#include "core/refinement/second_derivatives.h"
#include "core/refinement/simplex_pieces.h"
#include "core/spline/bezier.h"

#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int corners>
glm::dvec3 mixed(const std::array<glm::dvec3, corners>& at_corners, const glm::dvec3& weight)
{
    glm::dvec3 out(0);
    for (int i = 0; i < corners; ++i) out += weight[i] * at_corners[at(i)];
    return out;
}

template <int corners>
int net_of(const DisplacementCells::Cell& cell, const glm::ivec3& orders,
           const std::array<glm::dvec3, corners>& uvw, NetPoints<corners>& net)
{
    std::array<std::array<double, corners>, 3> local;
    for (int a = 0; a < 3; ++a)
        for (std::size_t i = 0; i < corners; ++i) local[at(a)][i] = cell.local(uvw[i], a);
    return compose<corners>(cell.points.data(), orders, local, net);
}

// Subtracts the linear net with these corners from a net.
template <int corners>
void subtract_linear(NetPoints<corners>& net, int degree,
                     const std::array<glm::dvec3, corners>& linear)
{
    std::array<glm::dvec4, corners> step;
    for (std::size_t i = 0; i < corners; ++i)
        step[i] = glm::dvec4(linear[i] / static_cast<double>(degree), 0);
    each_term<corners>(degree, [&](int index, int r, int c) {
        glm::dvec4& off = net[at(index)];
        off -= step[0] * static_cast<double>(degree - r) + step[1] * static_cast<double>(r - c);
        if constexpr (corners == 3) off -= step[2] * static_cast<double>(c);
    });
}

// Bounds the rounding error: of the coefficients, which are means of some hundred control points,
// and of the place of a corner in its cell.
template <int corners>
double doubt(const DisplacementCells& cells, const std::array<glm::dvec3, corners>& uvw,
             const glm::dvec3& cell_size)
{
    double relative = 2e-13;
    for (int a = 0; a < 3; ++a) {
        double far = 0;
        for (const glm::dvec3& p : uvw) far = std::max(far, std::abs(p[a]));
        relative += 8 * cells.orders()[a] * 2.3e-16 * far / cell_size[a];
    }
    return relative * cells.largest();
}

bool by_second_derivatives(BoundMethod method)
{
    return method < BoundMethod::net_affine;
}

// Returns the affine map from the corners to their displacements; its derivative across the simplex
// is the one in its middle.
template <int corners>
glm::dmat4 affine_through(const DisplacementCells& cells,
                          const std::array<glm::dvec3, corners>& uvw,
                          const std::array<glm::dvec3, corners>& d)
{
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : uvw) middle += p / double{corners};
    const Jet<glm::dvec3> jet = evaluate(cells.displacement(), middle, 1);
    const glm::dmat3 slope(jet.first[0], jet.first[1], jet.first[2]);
    glm::dmat3 from(1), to(1);
    from[0] = uvw[1] - uvw[0];
    to[0] = d[1] - d[0];
    if constexpr (corners == 3) {
        from[1] = uvw[2] - uvw[0];
        to[1] = d[2] - d[0];
    } else {
        const glm::dvec3 e = glm::abs(from[0]);
        glm::dvec3 least(0);
        least[e.x <= e.y && e.x <= e.z ? 0 : e.y <= e.z ? 1 : 2] = 1;
        from[1] = glm::cross(from[0], least);
        to[1] = slope * from[1];
    }
    from[2] = glm::cross(from[0], from[1]);
    to[2] = slope * from[2];
    glm::dmat4 out(to * glm::inverse(from));
    out[3] = glm::dvec4(d[0] - glm::dmat3(out) * uvw[0], 1);
    return out;
}

// Restricts Bezier points to the part of a cell between local parameters.
void restrict(std::array<glm::dvec4, max_order * max_order * max_order>& points,
              const glm::ivec3& n, const glm::dvec3& lo, const glm::dvec3& hi)
{
    const std::array<int, 3> stride{n.y * n.z, n.z, 1};
    for (int a = 0; a < 3; ++a) {
        const auto m = bezier_segment(n[a], lo[a], hi[a]);
        for (int i = 0; i < n.x * n.y * n.z; ++i) {
            if (i / stride[at(a)] % n[a] != 0) continue;
            std::array<glm::dvec4, max_order> row;
            for (int k = 0; k < n[a]; ++k) row[at(k)] = points[at(i + k * stride[at(a)])];
            for (int k = 0; k < n[a]; ++k) {
                glm::dvec4 sum(0);
                for (int j = 0; j < n[a]; ++j) sum += row[at(j)] * m[at(k * n[a] + j)];
                points[at(i + k * stride[at(a)])] = sum;
            }
        }
    }
}

} // namespace

double circumradius(const std::array<glm::dvec3, 3>& p)
{
    const double a = glm::distance(p[1], p[2]), b = glm::distance(p[2], p[0]),
                 c = glm::distance(p[0], p[1]),
                 area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    return area > 1e-13 * a * b ? a * b * c / (2 * area) : infinity;
}

double least_circle_radius(const std::array<glm::dvec3, 3>& p)
{
    std::array<double, 3> s;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 e = p[(i + 1) % 3] - p[i];
        s[i] = glm::dot(e, e);
    }
    std::sort(s.begin(), s.end());
    return s[2] >= s[0] + s[1] ? std::sqrt(s[2]) / 2 : circumradius(p);
}

ErrorBounds::Corner ErrorBounds::corner(const glm::dvec3& uvw) const
{
    return {uvw, evaluate(cells_->displacement(), uvw).value};
}

const DisplacementCells::Cell& ErrorBounds::cell(const glm::ivec3& slabs)
{
    if (loaded_ && cell_.slabs == slabs) return cell_;
    cells_->load(slabs, cell_);
    loaded_ = true;
    cubic_.reset();
    return cell_;
}

// A Work bounds one simplex by its method.
template <int corners> struct ErrorBounds::Work {
    ErrorBounds& bounds;
    std::array<glm::dvec3, corners> uvw, d;
    double extra = 0; // for corners that were clamped to the end of an axis

    Work(ErrorBounds& all, const std::array<Corner, corners>& from) : bounds(all)
    {
        for (std::size_t i = 0; i < corners; ++i) {
            uvw[i] = from[i].uvw;
            d[i] = from[i].displacement;
            for (int a = 0; a < 3; ++a) {
                uvw[i][a] = all.cells_->axis(a).snapped(uvw[i][a]);
                extra = std::max(extra, std::abs(uvw[i][a] - from[i].uvw[a]) *
                                            all.cells_->slopes()[a] * 3);
            }
        }
    }
    // Raises the maximum; NaN counts as infinite.
    static void raise(double& most, double by)
    {
        if (!(by <= most)) most = std::isnan(by) ? infinity : by;
    }

    double net(bool subdivided)
    {
        double most = 0;
        const auto one = [&](const SimplexPiece<corners>& piece) {
            const DisplacementCells::Cell& cell = bounds.cell(piece.slabs);
            std::array<glm::dvec3, corners> linear;
            for (std::size_t i = 0; i < corners; ++i)
                linear[i] = mixed<corners>(d, piece.weight[i]);
            double error = subdivided ? infinity : cubic(cell, piece, linear);
            if (error == infinity) {
                NetPoints<corners> points;
                const int degree =
                    net_of<corners>(cell, bounds.cells_->orders(), piece.uvw, points);
                subtract_linear<corners>(points, degree, linear);
                const int levels = subdivided ? 5 : 2;
                error = std::sqrt(longest_squared<corners>(points, degree, levels, 0));
            }
            raise(most, error + doubt<corners>(*bounds.cells_, piece.uvw, cell.size));
        };
        const Crossing crossing = each_piece<corners>(*bounds.cells_, uvw, one);
        return crossing.jump ? infinity : most + extra;
    }

    // Bounds a small piece, where terms above the third order are small; infinite otherwise.
    double cubic(const DisplacementCells::Cell& cell, const SimplexPiece<corners>& piece,
                 const std::array<glm::dvec3, corners>& linear)
    {
        std::array<glm::dvec3, corners> local;
        for (std::size_t i = 0; i < corners; ++i)
            for (int a = 0; a < 3; ++a) local[i][a] = cell.local(piece.uvw[i], a);
        if (!bounds.cubic_) bounds.cubic_.emplace(cell, bounds.cells_->orders());
        const CubicError::Bound bound = (*bounds.cubic_)(local, linear);
        return bound.left_out <= 0.02 * bound.error ? bound.error + bound.left_out : infinity;
    }

    double net_affine()
    {
        const DisplacementCells& cells = *bounds.cells_;
        const glm::dmat4 affine = affine_through<corners>(cells, uvw, d);
        double most = 0, off = 0;
        for (std::size_t i = 0; i < corners; ++i)
            raise(off, glm::distance(glm::dvec3(affine * glm::dvec4(uvw[i], 1)), d[i]));
        glm::dvec3 lo(infinity), hi(-infinity);
        for (const glm::dvec3& p : uvw) {
            lo = glm::min(lo, p);
            hi = glm::max(hi, p);
        }
        glm::ivec3 first, last;
        for (int a = 0; a < 3; ++a) {
            first[a] = cells.axis(a).upper(lo[a]);
            last[a] = std::max(first[a], cells.axis(a).lower(hi[a]));
            for (int s = first[a]; s < last[a]; ++s)
                if (cells.axis(a).joint(s) == AxisSlabs::Joint::jump) return infinity;
        }
        const glm::ivec3 n = cells.orders();
        glm::ivec3 s;
        for (s.x = first.x; s.x <= last.x; ++s.x)
            for (s.y = first.y; s.y <= last.y; ++s.y)
                for (s.z = first.z; s.z <= last.z; ++s.z) {
                    const DisplacementCells::Cell& cell = bounds.cell(s);
                    glm::dvec3 from = lo, to = hi, local_from, local_to;
                    for (int a = 0; a < 3; ++a) {
                        from[a] = std::max(lo[a], cells.axis(a).begin(s[a]));
                        to[a] = std::min(hi[a], cells.axis(a).end(s[a]));
                        local_from[a] = cell.local(from, a);
                        local_to[a] = cell.local(to, a);
                    }
                    auto points = cell.points;
                    restrict(points, n, local_from, local_to);
                    double worst = 0;
                    for (int i = 0; i < n.x * n.y * n.z; ++i) {
                        const glm::dvec3 share =
                            glm::dvec3(i / (n.y * n.z), i / n.z % n.y, i % n.z) / glm::dvec3(n - 1);
                        const glm::dvec3 p = from + (to - from) * share;
                        raise(worst, glm::distance(glm::dvec3(points[at(i)]),
                                                   glm::dvec3(affine * glm::dvec4(p, 1))));
                    }
                    raise(most, worst + doubt<corners>(cells, uvw, cell.size));
                }
        return most + off + extra;
    }

    double second_derivatives(BoundMethod method)
    {
        SecondDerivatives<corners> m(method, uvw);
        const Crossing crossing =
            each_piece<corners>(*bounds.cells_, uvw, [&](const SimplexPiece<corners>& piece) {
                // A sliver would lose all digits; the polynomial of the cell over the whole simplex
                // is used instead.
                const bool whole = !m.worth_cutting(piece.weight);
                const DisplacementCells::Cell& cell = bounds.cell(piece.slabs);
                SimplexPiece<corners> all = SimplexPiece<corners>{piece.slabs, {}, uvw};
                for (int i = 0; i < corners; ++i) {
                    all.weight[at(i)] = glm::dvec3(0);
                    all.weight[at(i)][i] = 1;
                }
                const SimplexPiece<corners>& used = whole ? all : piece;
                std::array<std::array<double, corners>, 3> local;
                for (int a = 0; a < 3; ++a)
                    for (std::size_t i = 0; i < corners; ++i) {
                        const double t = (used.uvw[i][a] - cell.begin[a]) / cell.size[a];
                        local[at(a)][i] = cell.beyond[a] || !whole ? cell.local(used.uvw[i], a)
                                          : cell.mirrored[a]       ? 1 - t
                                                                   : t;
                    }
                NetPoints<corners> points;
                const int degree =
                    compose<corners>(cell.points.data(), bounds.cells_->orders(), local, points);
                m.add(points, degree, used.weight,
                      doubt<corners>(*bounds.cells_, used.uvw, cell.size));
            });
        return crossing.kink ? infinity : m.bound() * (1 + 1e-12) + extra;
    }

    double by(BoundMethod method)
    {
        if (bounds.cells_->zero()) return 0;
        if (by_second_derivatives(method)) return second_derivatives(method);
        if (method == BoundMethod::net_affine) return net_affine();
        return net(method == BoundMethod::composed_net_subdivided);
    }
};

double ErrorBounds::triangle(const std::array<Corner, 3>& corners, BoundMethod method)
{
    return Work<3>(*this, corners).by(method);
}

double ErrorBounds::edge(const std::array<Corner, 2>& corners, BoundMethod method)
{
    return Work<2>(*this, corners).by(method);
}

std::vector<ErrorBounds::EdgePiece> ErrorBounds::edge_pieces(const std::array<Corner, 2>& corners)
{
    std::vector<EdgePiece> out;
    const Work<2> work(*this, corners);
    each_piece<2>(*cells_, work.uvw, [&](const SimplexPiece<2>& piece) {
        EdgePiece& one = out.emplace_back();
        one.from = piece.weight[0].y;
        one.to = piece.weight[1].y;
        one.degree = net_of<2>(cell(piece.slabs), cells_->orders(), piece.uvw, one.net);
    });
    return out;
}

} // namespace trivar
