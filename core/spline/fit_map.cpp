// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/fit_map.h"

#include "core/base/rejected.h"

#include <Eigen/Sparse>
#include <cmath>
#include <string>

namespace trivar {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Returns 2 for a twisted axis, which is solved as a periodic one of twice the length: the second
// half are the mirrored points, and the solution of mirrored data is itself mirrored.
int sheets(const Knots& knots)
{
    return knots.closure() == Closure::twisted ? 2 : 1;
}

void check_size(long long rows, long long columns)
{
    constexpr long long most = 1 << 24; // 128 MiB
    if (rows * columns > most)
        throw Rejected("a fit of " + std::to_string(columns) + " samples by " +
                       std::to_string(rows) + " control points on an axis is too large");
}

// Makes the collocation matrix: row s holds the basis functions, or their derivatives, at parameter
// s. The columns are the control points of all sheets.
Sparse collocation(const Knots& knots, std::span<const double> parameters, int derivative = 0)
{
    const AxisMap once = sampling_map(knots, parameters, derivative);
    const int m = static_cast<int>(parameters.size()), n = knots.count() * sheets(knots);
    std::vector<Eigen::Triplet<double>> entries;
    for (int sheet = 0; sheet < sheets(knots); ++sheet)
        for (int s = 0; s < m; ++s)
            for (int k = 0; k < once.width; ++k) {
                const auto entry =
                    static_cast<std::size_t>(s) * static_cast<std::size_t>(once.width) +
                    static_cast<std::size_t>(k);
                const int first = once.first[static_cast<std::size_t>(s)];
                entries.emplace_back(sheet * m + s, (first + k + sheet * knots.count()) % n,
                                     once.weights[entry]);
            }
    Sparse out(m * sheets(knots), n);
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
}

// Computes the matrix of int N_i'' N_j'' dt, exactly, by Gauss quadrature: between breaks the
// integrand is a polynomial of degree at most 6.
Sparse roughness(const Knots& knots)
{
    constexpr std::array<double, 4> node{-0.8611363115940526, -0.3399810435848563,
                                         0.3399810435848563, 0.8611363115940526};
    constexpr std::array<double, 4> share{0.3478548451374538, 0.6521451548625461,
                                          0.6521451548625461, 0.3478548451374538};
    std::vector<double> parameters, weights;
    const std::vector<double> breaks = knots.breaks();
    for (std::size_t b = 0; b + 1 < breaks.size(); ++b)
        for (std::size_t k = 0; k < node.size(); ++k) {
            const double half = (breaks[b + 1] - breaks[b]) / 2;
            parameters.push_back(breaks[b] + half * (1 + node[k]));
            weights.push_back(half * share[k]);
        }
    const Sparse d = collocation(knots, parameters, std::min(2, knots.degree()));
    Eigen::VectorXd w(d.rows());
    for (int i = 0; i < d.rows(); ++i) w[i] = weights[static_cast<std::size_t>(i) % weights.size()];
    return d.transpose() * w.asDiagonal() * d;
}

// Returns the rows of the first sheet of a solution as a map.
AxisMap map_of(const Eigen::MatrixXd& solution, int count)
{
    AxisMap map;
    map.width = static_cast<int>(solution.cols());
    map.first.assign(static_cast<std::size_t>(count), 0);
    for (int i = 0; i < count; ++i)
        for (int s = 0; s < map.width; ++s) map.weights.push_back(solution(i, s));
    return map;
}

void check_samples(const Knots& knots, std::span<const double> parameters,
                   const FitOptions& options)
{
    for (const double t : parameters)
        if (!std::isfinite(t)) throw Rejected("a parameter of the samples is not a number");
    if (!options.weights.empty() && options.weights.size() != parameters.size())
        throw Rejected("there are " + std::to_string(options.weights.size()) + " weights for " +
                       std::to_string(parameters.size()) + " samples");
    for (const double w : options.weights)
        if (!(w >= 0 && std::isfinite(w))) throw Rejected("a weight of the samples is negative");
    if (!(options.smoothing >= 0 && std::isfinite(options.smoothing)))
        throw Rejected("the smoothing is negative");
    const auto& t = knots.values();
    const auto end = t.size() - 1, d = static_cast<std::size_t>(knots.degree());
    if (options.ends && (knots.closure() != Closure::open || t[0] != t[d] || t[end] != t[end - d]))
        throw Rejected("only a clamped curve can pass through its first and last sample");
    if (options.ends && parameters.size() < 2)
        throw Rejected("a curve through its first and last sample needs two of them");
}

// Replaces equation i of the normal equations by P_i = q_column.
void pin(Sparse& a, Eigen::MatrixXd& right, int i, int column)
{
    right.col(column) -= Eigen::VectorXd(a.col(i));
    a.prune([i](int row, int col, double) { return row != i && col != i; });
    a.coeffRef(i, i) = 1;
    right.row(i).setZero();
    right(i, column) = 1;
}

Eigen::VectorXd weights_of(const Sparse& collocation, const FitOptions& options)
{
    Eigen::VectorXd w = Eigen::VectorXd::Ones(collocation.rows());
    for (int s = 0; s < w.size() && !options.weights.empty(); ++s)
        w[s] = options.weights[static_cast<std::size_t>(s) % options.weights.size()];
    return w;
}

// Solves the normal equations with the given right sides for the control points.
AxisMap solution(const Knots& knots, Sparse a, Eigen::MatrixXd right, const FitOptions& options)
{
    if (options.smoothing > 0) a += options.smoothing * roughness(knots);
    if (options.ends) {
        pin(a, right, 0, 0);
        pin(a, right, static_cast<int>(a.rows()) - 1, static_cast<int>(right.cols()) - 1);
    }
    const Eigen::SimplicialLDLT<Sparse> ldlt(a);
    // A pivot this far below the largest one is a zero with rounding errors.
    const bool determined =
        ldlt.info() == Eigen::Success &&
        ldlt.vectorD().minCoeff() > 1e-13 * ldlt.vectorD().cwiseAbs().maxCoeff();
    if (!determined)
        throw Rejected("the samples do not determine every control point: there are too few of "
                       "them, or none near some knots");
    return map_of(ldlt.solve(right), knots.count());
}

} // namespace

std::vector<double> greville_sites(const Knots& knots)
{
    std::vector<double> sites;
    sites.reserve(static_cast<std::size_t>(knots.count()));
    for (int i = 0; i < knots.count(); ++i) sites.push_back(knots.into_domain(knots.greville(i)).t);
    return sites;
}

AxisMap interpolation_map(const Knots& knots)
{
    const int n = knots.count() * sheets(knots);
    check_size(n, n);
    Eigen::SparseLU<Sparse> lu(collocation(knots, greville_sites(knots)));
    Eigen::MatrixXd inverse;
    if (lu.info() == Eigen::Success) inverse = lu.solve(Eigen::MatrixXd::Identity(n, n).eval());
    // Interpolation at the Greville abscissae is well conditioned for orders up to 6 (de Boor
    // 1978); a huge inverse means that two of them coincide.
    if (lu.info() != Eigen::Success || !(inverse.cwiseAbs().maxCoeff() < 1e9))
        throw Rejected("this axis cannot be interpolated: two of its Greville abscissae coincide");
    return map_of(inverse, knots.count());
}

AxisMap normal_inverse(const Knots& knots, std::span<const double> parameters,
                       const FitOptions& options)
{
    check_samples(knots, parameters, options);
    const int n = knots.count() * sheets(knots);
    check_size(n, n);
    const Sparse b = collocation(knots, parameters);
    return solution(knots, b.transpose() * weights_of(b, options).asDiagonal() * b,
                    Eigen::MatrixXd::Identity(n, n), options);
}

AxisMap least_squares_map(const Knots& knots, std::span<const double> parameters,
                          const FitOptions& options)
{
    check_samples(knots, parameters, options);
    check_size(knots.count() * sheets(knots),
               static_cast<long long>(parameters.size()) * sheets(knots));
    const Sparse b = collocation(knots, parameters);
    const Sparse weighted = b.transpose() * weights_of(b, options).asDiagonal();
    return solution(knots, weighted * b, Eigen::MatrixXd(weighted), options);
}

int sample_count(const Knots& knots, const AxisMap& map)
{
    return map.width / sheets(knots);
}

void check_value_count(std::size_t values, std::span<const int> counts)
{
    std::size_t wanted = 1;
    for (const int count : counts) wanted *= static_cast<std::size_t>(count);
    if (values != wanted)
        throw Rejected("there are " + std::to_string(values) + " values where " +
                       std::to_string(wanted) + " are wanted");
}

} // namespace trivar
