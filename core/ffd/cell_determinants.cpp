// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/cell_determinants.h"

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/spline/insert.h"

#include <algorithm>
#include <cmath>
#include <hwy/aligned_allocator.h>
#include <hwy/base.h>
#include <limits>

namespace trivar {
namespace {

// A Two holds one number for two cells; a Four for four, on processors with AVX2. Multiplications
// and additions are not fused, so that both give the same bits.
using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
template <class Lanes> inline constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);

std::vector<double> binomial_row(int n)
{
    std::vector<double> row{1};
    for (int k = 1; k <= n; ++k) row.push_back(row.back() * (n - k + 1) / k);
    return row;
}

// A Net is an array of coefficients, w fastest.
struct Net {
    int u, v, w;
    std::size_t count() const { return at(u) * at(v) * at(w); }
};

// Computes the product of binomials of each coefficient. Coefficients times these are coefficients
// of powers of t / (1 - t), so that a product of polynomials is a convolution.
std::vector<double> binomials(const Net& net)
{
    std::vector<double> out;
    out.reserve(net.count());
    const std::vector<double> u = binomial_row(net.u - 1), v = binomial_row(net.v - 1),
                              w = binomial_row(net.w - 1);
    for (const double x : u)
        for (const double y : v)
            for (const double z : w) out.push_back(x * y * z);
    return out;
}

template <class Lanes> struct Product {
    const Lanes *a, *b;
};

// Adds up products of scaled polynomials, with la coefficients of a and lb of b along w. A row of
// the result stays in registers.
template <int la, int lb, std::size_t terms, class Lanes>
HWY_INLINE void convolved(const Net& a, const Net& b,
                          const std::array<Product<Lanes>, terms>& products, Lanes* out)
{
    for (int I = 0; I < a.u + b.u - 1; ++I)
        for (int J = 0; J < a.v + b.v - 1; ++J) {
            Lanes row[la + lb - 1] = {};
            for (const Product<Lanes>& p : products)
                for (int i = std::max(0, I - b.u + 1); i <= std::min(a.u - 1, I); ++i)
                    for (int j = std::max(0, J - b.v + 1); j <= std::min(a.v - 1, J); ++j) {
                        const Lanes* left = p.a + (i * a.v + j) * la;
                        const Lanes* right = p.b + ((I - i) * b.v + J - j) * lb;
                        HWY_UNROLL(16)
                        for (int x = 0; x < la; ++x) HWY_UNROLL(16)
                        for (int y = 0; y < lb; ++y) row[x + y] += left[x] * right[y];
                    }
            HWY_UNROLL(16)
            for (int k = 0; k < la + lb - 1; ++k) *out++ = row[k];
        }
}

template <int la, int lb, std::size_t terms>
void convolve(const Net& a, const Net& b, const std::array<Product<Two>, terms>& products, Two* out)
{
    convolved<la, lb, terms, Two>(a, b, products, out);
}

#if defined(__x86_64__)
template <int la, int lb, std::size_t terms>
__attribute__((target("avx2"))) void
convolve(const Net& a, const Net& b, const std::array<Product<Four>, terms>& products, Four* out)
{
    convolved<la, lb, terms, Four>(a, b, products, out);
}
#endif

// SomeCells computes as many cells at once as there are lanes: the data that cells of a lattice
// share, and buffers.
template <class Lanes> class SomeCells {
public:
    SomeCells(const CellGrid& grid, const Lattice& lattice) : grid_(grid), lattice_(lattice)
    {
        const auto& axes = lattice.displacement.axes;
        points_ = {axes[0].order(), axes[1].order(), axes[2].order()};
        slope_ = {Net{points_.u - 1, points_.v, points_.w},
                  Net{points_.u, points_.v - 1, points_.w},
                  Net{points_.u, points_.v, points_.w - 1}};
        cross_ = {2 * points_.u - 1, 2 * points_.v - 2, 2 * points_.w - 2};
        whole_ = {3 * points_.u - 3, 3 * points_.v - 3, 3 * points_.w - 3};
        for (std::size_t a = 0; a < 3; ++a) binomials_[a] = binomials(slope_[a]);
        unscale_ = binomials(whole_);
        for (double& x : unscale_) x = 1 / x;
        p_ = room(3 * points_.count());
        q_ = room(3 * points_.count());
        for (std::size_t a = 0; a < 3; ++a) d_[a] = room(3 * slope_[a].count());
        minus_ = room(3 * slope_[1].count());
        c_ = room(3 * cross_.count());
        det_ = room(whole_.count());
        out_.f.degree = {whole_.u - 1, whole_.v - 1, whole_.w - 1};
        out_.f.coefficients.resize(whole_.count());
    }

    void compute(const std::array<std::size_t, lanes<Lanes>>& cells)
    {
        for (std::size_t lane = 0; lane < cells.size(); ++lane)
            spans_[lane] = grid_.spans(cells[lane]);
        gather();
        for (int axis = 0; axis < 3; ++axis) to_bezier(axis);
        for (int axis = 0; axis < 3; ++axis) take_slope(axis);
        switch (points_.w) {
        case 2: multiply<2>(); break;
        case 3: multiply<3>(); break;
        case 4: multiply<4>(); break;
        case 5: multiply<5>(); break;
        default: multiply<6>();
        }
        least_ = most_ = det_[0] * unscale_[0];
        sum_ = Lanes{};
        for (std::size_t i = 0; i < whole_.count(); ++i) {
            const Lanes x = det_[i] *= unscale_[i];
            least_ = x < least_ ? x : least_;
            most_ = x > most_ ? x : most_;
            sum_ += x;
        }
    }

    const CellDeterminant& of(std::size_t lane)
    {
        for (std::size_t i = 0; i < whole_.count(); ++i) out_.f.coefficients[i] = det_[i][lane];
        out_.least = least_[lane];
        out_.most = most_[lane];
        out_.mean = sum_[lane] / static_cast<double>(whole_.count());
        out_.doubt = doubt(lane);
        return out_;
    }

private:
    // Buffers are aligned for all lanes, which operator new does not guarantee.
    using Room = hwy::AlignedFreeUniquePtr<Lanes[]>;
    static Room room(std::size_t count) { return hwy::AllocateAligned<Lanes>(count); }

    void gather()
    {
        const Trivariate<glm::dvec3>& f = lattice_.displacement;
        const std::size_t n = points_.count();
        for (std::size_t lane = 0; lane < lanes<Lanes>; ++lane) {
            const auto& [u, v, w] = spans_[lane];
            double most = 0;
            Lanes* to = p_.get();
            for (int i = 0; i < points_.u; ++i)
                for (int j = 0; j < points_.v; ++j)
                    for (int k = 0; k < points_.w; ++k, ++to) {
                        const glm::dvec3& p = f.point(u->first + i, v->first + j, w->first + k);
                        for (std::size_t c = 0; c < 3; ++c)
                            to[c * n][lane] = p[static_cast<int>(c)];
                        most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
                    }
            largest_[lane] = most;
        }
    }

    void to_bezier(int axis)
    {
        const int order = axis == 0 ? points_.u : axis == 1 ? points_.v : points_.w;
        const std::size_t inner = axis == 0   ? at(points_.v) * at(points_.w)
                                  : axis == 1 ? at(points_.w)
                                              : 1;
        const std::size_t block = inner * at(order);
        std::array<Lanes, max_order * max_order> weight{};
        for (std::size_t i = 0; i < at(order * order); ++i)
            for (std::size_t lane = 0; lane < lanes<Lanes>; ++lane)
                weight[i][lane] = spans_[lane][at(axis)]->bezier[i];
        for (std::size_t begin = 0; begin < 3 * points_.count(); begin += block)
            for (std::size_t i = 0; i < at(order); ++i)
                for (std::size_t b = begin; b < begin + inner; ++b) {
                    Lanes sum{};
                    for (std::size_t r = 0; r < at(order); ++r)
                        sum += weight[i * at(order) + r] * p_[b + r * inner];
                    q_[b + i * inner] = sum;
                }
        std::swap(p_, q_);
    }

    // Computes the scaled coefficients of F_u, F_v or F_w, and their bounds.
    void take_slope(int axis)
    {
        const Net net = slope_[at(axis)];
        const int step = axis == 0 ? points_.v * points_.w : axis == 1 ? points_.w : 1;
        const int degree = (axis == 0 ? points_.u : axis == 1 ? points_.v : points_.w) - 1;
        Lanes factor{};
        for (std::size_t lane = 0; lane < lanes<Lanes>; ++lane) {
            const CellGrid::Span& span = *spans_[lane][at(axis)];
            factor[lane] = degree / (span.hi - span.lo);
        }
        const std::size_t n = points_.count(), m = net.count();
        const glm::dvec3 rest(lattice_.rest[axis]);
        const std::vector<double>& scale = binomials_[at(axis)];
        Lanes most{};
        Lanes* to = d_[at(axis)].get();
        std::size_t which = 0;
        for (int i = 0; i < net.u; ++i)
            for (int j = 0; j < net.v; ++j)
                for (int k = 0; k < net.w; ++k, ++to, ++which) {
                    const Lanes* from = p_.get() + (i * points_.v + j) * points_.w + k;
                    Lanes square{};
                    for (std::size_t c = 0; c < 3; ++c) {
                        const Lanes slope = (from[at(step) + c * n] - from[c * n]) * factor +
                                            rest[static_cast<int>(c)];
                        square += slope * slope;
                        to[c * m] = slope * scale[which];
                    }
                    most = square > most ? square : most;
                }
        for (std::size_t lane = 0; lane < lanes<Lanes>; ++lane) {
            steepest_[lane][axis] = std::sqrt(most[lane]);
            // A Bezier point is a weighted mean of control points with some twenty roundings per
            // axis, and the sums have as many: 64 of 2^-52 of the largest control point bound both
            // for a difference. Three coordinates double that.
            slope_doubt_[lane][axis] =
                256 * epsilon * largest_[lane] * factor[lane] + 4 * epsilon * steepest_[lane][axis];
        }
    }

    template <int order_w> void multiply()
    {
        const std::size_t nv = slope_[1].count(), nw = slope_[2].count(), nu = slope_[0].count(),
                          nc = cross_.count();
        const Lanes *u = d_[0].get(), *v = d_[1].get(), *w = d_[2].get();
        for (std::size_t i = 0; i < 3 * nv; ++i) minus_[i] = -v[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
            convolve<order_w, order_w - 1, 2>(slope_[1], slope_[2],
                                              {Product<Lanes>{v + d * nv, w + e * nw},
                                               Product<Lanes>{minus_.get() + e * nv, w + d * nw}},
                                              c_.get() + c * nc);
        }
        convolve<order_w, 2 * order_w - 2, 3>(slope_[0], cross_,
                                              {Product<Lanes>{u, c_.get()},
                                               Product<Lanes>{u + nu, c_.get() + nc},
                                               Product<Lanes>{u + 2 * nu, c_.get() + 2 * nc}},
                                              det_.get());
    }

    // Bounds the rounding error of the coefficients. A coefficient is a mean, with positive
    // weights, of determinants of three slopes. A sum of n products is off by n roundings of the
    // sum of their sizes, which is at most twice the product of the three largest slopes;
    // subdivision adds at most a hundred.
    double doubt(std::size_t lane) const
    {
        const glm::dvec3 s = steepest_[lane], e = slope_doubt_[lane];
        const double terms = static_cast<double>(3 * slope_[0].count() + 2 * slope_[1].count());
        return 2 * (epsilon * (terms + 256) * s.x * s.y * s.z + e.x * s.y * s.z + s.x * e.y * s.z +
                    s.x * s.y * e.z);
    }

    static constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const CellGrid& grid_;
    const Lattice& lattice_;
    Net points_{}, cross_{}, whole_{};
    std::array<Net, 3> slope_{};
    std::array<std::vector<double>, 3> binomials_;
    std::vector<double> unscale_;
    std::array<std::array<const CellGrid::Span*, 3>, lanes<Lanes>> spans_{};
    // Bezier points, slopes, minus F_v and F_v x F_w, indexed by coordinate, then net; and det J.
    Room p_, q_, minus_, c_, det_;
    std::array<Room, 3> d_;
    Lanes least_, most_, sum_; // of the coefficients of det J
    std::array<double, lanes<Lanes>> largest_{};
    std::array<glm::dvec3, lanes<Lanes>> steepest_{}, slope_doubt_{};
    CellDeterminant out_;
};

} // namespace

CellGrid::CellGrid(const std::array<Knots, 3>& axes) : axes_(axes)
{
    for (std::size_t a = 0; a < 3; ++a) {
        const std::vector<double>& t = axes[a].values();
        const int d = axes[a].degree();
        for (int s = d; s < axes[a].unwrapped_count(); ++s) {
            Span span{t[at(s)], t[at(s + 1)], s - d, {}};
            if (!(span.lo < span.hi)) continue;
            std::array<double, max_order> corner;
            corner.fill(span.lo);
            for (int i = 0; i <= d; ++i) {
                if (i > 0) corner[at(d - i)] = span.hi;
                const auto row = blossom(t, s, d, corner.data());
                std::copy_n(row.begin(), d + 1, span.bezier.begin() + i * (d + 1));
            }
            spans_[a].push_back(span);
        }
    }
}

glm::ivec3 CellGrid::size() const
{
    return {spans_[0].size(), spans_[1].size(), spans_[2].size()};
}

std::size_t CellGrid::count() const
{
    return spans_[0].size() * spans_[1].size() * spans_[2].size();
}

std::array<std::vector<double>, 3> CellGrid::breaks() const
{
    return {axes_[0].breaks(), axes_[1].breaks(), axes_[2].breaks()};
}

std::array<const CellGrid::Span*, 3> CellGrid::spans(std::size_t cell) const
{
    const std::size_t nw = spans_[2].size(), nv = spans_[1].size();
    return {&spans_[0][cell / nw / nv], &spans_[1][cell / nw % nv], &spans_[2][cell % nw]};
}

CellGrid::Place CellGrid::place(std::size_t cell) const
{
    const auto [u, v, w] = spans(cell);
    return {{u->lo, v->lo, w->lo}, {u->hi, v->hi, w->hi}};
}

std::vector<int> CellGrid::touched(std::span<const PointMove> moves) const
{
    std::vector<bool> is(count());
    const auto mark = [&](const glm::ivec3& unwrapped) {
        std::array<std::array<int, 2>, 3> range{};
        for (std::size_t a = 0; a < 3; ++a) {
            const int i = unwrapped[static_cast<int>(a)], d = axes_[a].degree();
            const auto& s = spans_[a];
            const auto begin = std::partition_point(s.begin(), s.end(),
                                                    [&](const Span& x) { return x.first + d < i; });
            const auto end =
                std::partition_point(begin, s.end(), [&](const Span& x) { return x.first <= i; });
            range[a] = {static_cast<int>(begin - s.begin()), static_cast<int>(end - s.begin())};
        }
        for (int u = range[0][0]; u < range[0][1]; ++u)
            for (int v = range[1][0]; v < range[1][1]; ++v)
                for (int w = range[2][0]; w < range[2][1]; ++w)
                    is[(at(u) * spans_[1].size() + at(v)) * spans_[2].size() + at(w)] = true;
    };
    const glm::ivec3 stored(axes_[0].count(), axes_[1].count(), axes_[2].count());
    for (const PointMove& move : moves) {
        // Visits each unwrapped index that stands for the point: a few turns of each axis; a turn
        // of a twisted axis mirrors the other two.
        for (int u = 0; u <= axes_[0].unwrapped_count() / stored.x; ++u)
            for (int v = 0; v <= axes_[1].unwrapped_count() / stored.y; ++v)
                for (int w = 0; w <= axes_[2].unwrapped_count() / stored.z; ++w) {
                    const glm::ivec3 turn(u, v, w);
                    glm::ivec3 i = move.index;
                    for (int a = 0; a < 3; ++a)
                        if (axes_[at(a)].closure() == Closure::twisted && turn[a] % 2 == 1)
                            for (int b = 0; b < 3; ++b)
                                if (b != a) i[b] = stored[b] - 1 - i[b];
                    mark(i + turn * stored);
                }
    }
    std::vector<int> out;
    for (std::size_t c = 0; c < is.size(); ++c)
        if (is[c]) out.push_back(static_cast<int>(c));
    return out;
}

namespace {

using Body = std::function<void(std::size_t which, const CellDeterminant&)>;

struct Block {
    std::size_t begin, end;
};

template <class Lanes>
HWY_INLINE void each_of_block(const CellGrid& grid, const Lattice& lattice,
                              std::span<const int> cells, const Block& block, const Body& body)
{
    SomeCells<Lanes> some(grid, lattice);
    for (std::size_t i = block.begin; i < block.end; i += lanes<Lanes>) {
        std::array<std::size_t, lanes<Lanes>> which{};
        for (std::size_t lane = 0; lane < which.size(); ++lane)
            which[lane] = at(cells[std::min(i + lane, block.end - 1)]);
        some.compute(which);
        for (std::size_t lane = 0; lane < which.size() && i + lane < block.end; ++lane)
            body(i + lane, some.of(lane));
    }
}

void two_by_two(const CellGrid& grid, const Lattice& lattice, std::span<const int> cells,
                const Block& block, const Body& body)
{
    each_of_block<Two>(grid, lattice, cells, block, body);
}

#if defined(__x86_64__)
__attribute__((target("avx2"), flatten)) void four_by_four(const CellGrid& grid,
                                                           const Lattice& lattice,
                                                           std::span<const int> cells,
                                                           const Block& block, const Body& body)
{
    each_of_block<Four>(grid, lattice, cells, block, body);
}
#endif

} // namespace

void each_determinant(const CellGrid& grid, const Lattice& lattice, std::span<const int> cells,
                      const std::function<void(std::size_t which, const CellDeterminant&)>& body)
{
    auto* each = &two_by_two;
#if defined(__x86_64__)
    if (cells.size() > 2 && __builtin_cpu_supports("avx2")) each = &four_by_four;
#endif
    parallel_blocks(cells.size(), 16, [&](std::size_t begin, std::size_t end) {
        each(grid, lattice, cells, {begin, end}, body);
    });
}

} // namespace trivar
