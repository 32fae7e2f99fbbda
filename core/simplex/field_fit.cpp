// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/field_fit.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/simplex/cell_search.h"
#include "core/simplex/shared_points.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t most_unknowns = 30'000; // a minute for the factorisation
constexpr double enough = 4;                  // samples' weight under a function
constexpr double hold = 0.5;                  // of a sample
constexpr int refinements = 2;                // of the solution

using Sparse = Eigen::SparseMatrix<double>;

int count_of(const std::vector<int>& numbers)
{
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1;
}

// The normal equations of the samples in one cell.
struct CellSums {
    std::vector<int> unknowns;  // ascending
    std::vector<double> square; // lower half: of unknown i and j <= i, at i (i + 1) / 2 + j
    std::vector<double> right, weight;
};

class Fit {
public:
    Fit(const Ref<SimplexBasis<3>>& basis, std::span<const FieldSample> samples)
        : basis_(basis),
          samples_(samples),
          function_unknown_(shared_points(basis->domain(), PointSharing::all)),
          unknowns_(static_cast<std::size_t>(count_of(function_unknown_)))
    {
        if (unknowns_ > most_unknowns)
            throw Rejected(fmt::format("A fit has at most {} coefficients, not {}: use fewer cells "
                                       "or a lesser degree.",
                                       with_commas(most_unknowns), with_commas(unknowns_)));
        for (const FieldSample& s : samples)
            if (!finite(s.at) || !std::isfinite(s.value))
                throw Rejected("A sample to fit is not a number.");
        point_unknown_.resize(basis->point_count());
        const std::size_t per_cell = function_unknown_.size() / basis->domain().cells.size();
        for (std::size_t i = 0; i < function_unknown_.size(); ++i)
            point_unknown_[static_cast<std::size_t>(basis->point_of(i / per_cell, i % per_cell))] =
                function_unknown_[i];
    }

    FieldFit operator()()
    {
        sort_samples();
        FieldFit out;
        out.coefficients = unknowns_;
        out.samples = order_.size();
        if (order_.size() < unknowns_)
            throw Rejected(fmt::format("{} samples in the domain are too few for {} coefficients.",
                                       with_commas(order_.size()), with_commas(unknowns_)));
        sum_cells();
        const Eigen::VectorXd c = solved(out.held);
        out.field = {basis_, {}};
        for (const int unknown : point_unknown_) out.field.values.push_back(c[unknown]);
        double square = 0;
        for (const CellSums& cell : cells_) { // |A c - b|^2 by the sums
            for (std::size_t i = 0; i < cell.unknowns.size(); ++i) {
                const double ci = c[cell.unknowns[i]];
                square -= 2 * ci * cell.right[i];
                for (std::size_t j = 0; j <= i; ++j)
                    square += (i == j ? 1 : 2) * ci * c[cell.unknowns[j]] *
                              cell.square[i * (i + 1) / 2 + j];
            }
        }
        for (const std::uint32_t s : order_)
            square += (samples_[s].value - middle_) * (samples_[s].value - middle_);
        out.rms = std::sqrt(std::max(0.0, square) / static_cast<double>(order_.size()));
        for (double& value : out.field.values) value += middle_;
        return out;
    }

private:
    // Sorts the samples by cell, then by number.
    void sort_samples()
    {
        const SimplexDomain<3>& domain = basis_->domain();
        SimplexMesh<3> mesh{{}, domain.cells};
        for (std::size_t v = 0; v < domain.vertex_count(); ++v)
            mesh.vertices.push_back(domain.vertex(static_cast<int>(v)));
        const CellSearch search(std::move(mesh));
        std::vector<int> cell(samples_.size());
        parallel_blocks(samples_.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) cell[i] = search.cell_at(samples_[i].at);
        });
        begin_.assign(domain.cells.size() + 1, 0);
        for (const int c : cell)
            if (c >= 0) ++begin_[static_cast<std::size_t>(c) + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        order_.resize(begin_.back());
        std::vector<std::size_t> next = begin_;
        double sum = 0;
        for (std::size_t i = 0; i < cell.size(); ++i)
            if (cell[i] >= 0) {
                order_[next[static_cast<std::size_t>(cell[i])]++] = static_cast<std::uint32_t>(i);
                sum += samples_[i].value;
            }
        // All are told from here, so that large values keep their digits.
        middle_ = order_.empty() ? 0 : sum / static_cast<double>(order_.size());
    }

    void sum_cells()
    {
        cells_.resize(begin_.size() - 1);
        parallel_blocks(cells_.size(), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) cells_[c] = sums_of(c);
        });
    }

    CellSums sums_of(std::size_t cell) const
    {
        CellSums out;
        std::vector<std::vector<std::pair<int, double>>> rows;
        std::vector<BasisValue<3>> values;
        for (std::size_t s = begin_[cell]; s < begin_[cell + 1]; ++s) {
            basis_->values_at(samples_[order_[s]].at, false, values);
            auto& row = rows.emplace_back();
            for (const BasisValue<3>& each : values)
                row.emplace_back(point_unknown_[static_cast<std::size_t>(each.point)], each.value);
            std::sort(row.begin(), row.end());
            for (const auto& [unknown, value] : row) out.unknowns.push_back(unknown);
        }
        std::sort(out.unknowns.begin(), out.unknowns.end());
        out.unknowns.erase(std::unique(out.unknowns.begin(), out.unknowns.end()),
                           out.unknowns.end());
        const std::size_t n = out.unknowns.size();
        out.square.assign(n * (n + 1) / 2, 0);
        out.right.assign(n, 0);
        out.weight.assign(n, 0);
        for (std::size_t s = 0; s < rows.size(); ++s) {
            const double value = samples_[order_[begin_[cell] + s]].value - middle_;
            std::vector<std::pair<std::size_t, double>> row; // by place, ascending
            for (const auto& [unknown, weight] : rows[s]) {
                const auto place = static_cast<std::size_t>(
                    std::lower_bound(out.unknowns.begin(), out.unknowns.end(), unknown) -
                    out.unknowns.begin());
                if (!row.empty() && row.back().first == place)
                    row.back().second += weight;
                else
                    row.emplace_back(place, weight);
            }
            for (std::size_t i = 0; i < row.size(); ++i) {
                const auto [at, weight] = row[i];
                out.right[at] += weight * value;
                out.weight[at] += weight;
                for (std::size_t j = 0; j <= i; ++j)
                    out.square[at * (at + 1) / 2 + row[j].first] += weight * row[j].second;
            }
        }
        return out;
    }

    // The mean of the samples under each unknown's functions; without any, of its neighbours.
    Eigen::VectorXd means(const Eigen::VectorXd& weight, Eigen::VectorXd right) const
    {
        std::vector<bool> known(unknowns_);
        for (Eigen::Index i = 0; i < right.size(); ++i) {
            known[static_cast<std::size_t>(i)] = weight[i] > 1e-6;
            right[i] = weight[i] > 1e-6 ? right[i] / weight[i] : 0;
        }
        const std::size_t per_cell = function_unknown_.size() / cells_.size();
        for (bool any = true; any;) { // a layer of cells each time
            any = false;
            const std::vector<bool> before = known;
            std::vector<std::pair<double, int>> sums(unknowns_);
            for (std::size_t c = 0; c < cells_.size(); ++c) {
                const std::span<const int> here(function_unknown_.data() + c * per_cell, per_cell);
                for (const int to : here)
                    for (const int from : here)
                        if (!before[static_cast<std::size_t>(to)] &&
                            before[static_cast<std::size_t>(from)]) {
                            sums[static_cast<std::size_t>(to)].first += right[from];
                            ++sums[static_cast<std::size_t>(to)].second;
                        }
            }
            for (std::size_t i = 0; i < unknowns_; ++i)
                if (sums[i].second > 0) {
                    right[static_cast<Eigen::Index>(i)] = sums[i].first / sums[i].second;
                    known[i] = any = true;
                }
        }
        return right;
    }

    Eigen::VectorXd solved(std::size_t& held) const
    {
        const auto n = static_cast<Eigen::Index>(unknowns_);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n), weight = right;
        std::vector<Eigen::Triplet<double, int>> terms;
        for (const CellSums& cell : cells_)
            for (std::size_t i = 0; i < cell.unknowns.size(); ++i) {
                right[cell.unknowns[i]] += cell.right[i];
                weight[cell.unknowns[i]] += cell.weight[i];
                for (std::size_t j = 0; j <= i; ++j)
                    if (const double x = cell.square[i * (i + 1) / 2 + j]; x != 0)
                        terms.emplace_back(cell.unknowns[i], cell.unknowns[j], x);
            }
        const Eigen::VectorXd mean = means(weight, right);
        for (int i = 0; i < n; ++i) {
            const double holding = hold * std::max(0.0, 1 - weight[i] / enough);
            held += holding > 0 ? 1 : 0;
            right[i] += holding * mean[i];
            terms.emplace_back(i, i, holding);
        }
        Sparse a(n, n);
        a.setFromTriplets(terms.begin(), terms.end());
        terms = {};
        Sparse solid = a; // a little more, where samples do not tell all
        const double little = 1e-10 * a.diagonal().mean();
        for (int i = 0; i < n; ++i) solid.coeffRef(i, i) += little;
        const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> ldlt(solid);
        if (ldlt.info() != Eigen::Success)
            throw Rejected("The samples do not tell the coefficients: use fewer cells or a lesser "
                           "degree.");
        Eigen::VectorXd c = mean;
        for (int step = 0; step <= refinements; ++step)
            c += ldlt.solve(right - a.selfadjointView<Eigen::Lower>() * c);
        return c;
    }

    const Ref<SimplexBasis<3>>& basis_;
    std::span<const FieldSample> samples_;
    std::vector<int> function_unknown_, point_unknown_;
    std::size_t unknowns_;
    std::vector<std::size_t> begin_; // of each cell's samples
    std::vector<std::uint32_t> order_;
    std::vector<CellSums> cells_;
    double middle_ = 0;
};

} // namespace

std::size_t fit_size(const SimplexDomain<3>& domain)
{
    return static_cast<std::size_t>(count_of(shared_points(domain, PointSharing::all)));
}

FieldFit fitted_field(const Ref<SimplexBasis<3>>& basis, std::span<const FieldSample> samples)
{
    return Fit(basis, samples)();
}

} // namespace trivar
