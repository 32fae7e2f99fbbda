// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/guard.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

bool overlap(const CellGrid::Place& cell, const Box& box)
{
    return glm::all(glm::lessThan(cell.lo, box.hi)) && glm::all(glm::lessThan(box.lo, cell.hi));
}

// Those of the cells that are to be judged.
std::vector<int> not_excepted(const CellGrid& grid, std::vector<int> cells,
                              const GuardOptions& options)
{
    std::erase_if(cells, [&](int cell) {
        const CellGrid::Place place = grid.place(static_cast<std::size_t>(cell));
        return std::any_of(options.excepted.begin(), options.excepted.end(),
                           [&](const Box& box) { return overlap(place, box); });
    });
    return cells;
}

std::vector<int> all_cells(const CellGrid& grid)
{
    std::vector<int> out(grid.count());
    std::iota(out.begin(), out.end(), 0);
    return out;
}

struct Judged {
    Verdict verdict = Verdict::unknown;
    double least = 0;
};

Judged judged(const CellGrid::Place& place, const CellDeterminant& det, int sign,
              const GuardOptions& options)
{
    Judged out{verdict_at_once(det, sign),
               std::isfinite(det.mean) ? sign > 0 ? det.least : -det.most : 0};
    if (out.verdict != Verdict::unknown) return out;
    out.verdict = Verdict::proven_good;
    for (const DoubtfulPart& part : doubtful_parts(place, det, sign, options.halving))
        if (out.verdict != Verdict::proven_bad) out.verdict = part.verdict;
    return out;
}

std::vector<Judged> judged(const CellGrid& grid, const Lattice& lattice,
                           const std::vector<int>& cells, int sign, const GuardOptions& options)
{
    std::vector<Judged> out(cells.size());
    each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
        out[i] = judged(grid.place(static_cast<std::size_t>(cells[i])), det, sign, options);
    });
    return out;
}

CellVerdicts with(CellVerdicts verdicts, const std::vector<int>& cells,
                  const std::vector<Judged>& judged)
{
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(cells[i]);
        verdicts.of[cell] = judged[i].verdict;
        verdicts.least[cell] = judged[i].least;
    }
    return verdicts;
}

// Whether a cell that was like `before` may become like `after`.
bool allowed(const Judged& before, const Judged& after)
{
    if (after.verdict == Verdict::proven_good) return true;
    return before.verdict != Verdict::proven_good && after.least >= before.least;
}

} // namespace

glm::ivec3 CellVerdicts::size() const
{
    return {breaks[0].size() - 1, breaks[1].size() - 1, breaks[2].size() - 1};
}

bool CellVerdicts::good() const
{
    return std::all_of(of.begin(), of.end(), [](Verdict v) {
        return v == Verdict::proven_good || v == Verdict::excepted;
    });
}

CellVerdicts judge(const Lattice& lattice, const GuardOptions& options)
{
    const CellGrid grid(lattice.displacement.axes);
    const std::vector<int> cells = not_excepted(grid, all_cells(grid), options);
    CellVerdicts out{grid.breaks(), std::vector<Verdict>(grid.count(), Verdict::excepted),
                     std::vector<double>(grid.count())};
    // Which sign is the right one is known only when all cells have been looked at.
    std::vector<Judged> positive(cells.size()), negative(cells.size());
    std::vector<double> volumes(cells.size()), sizes(cells.size());
    each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
        const CellGrid::Place place = grid.place(static_cast<std::size_t>(cells[i]));
        const glm::dvec3 edge = place.hi - place.lo;
        sizes[i] = edge.x * edge.y * edge.z;
        volumes[i] = det.mean * sizes[i];
        positive[i] = judged(place, det, 1, options);
        negative[i] = judged(place, det, -1, options);
    });
    const double volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    const double size = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    out.sign = volume < 0 ? -1 : 1;
    if (size > 0 && std::isfinite(volume)) out.typical = std::abs(volume) / size;
    const std::vector<Judged>& right = out.sign > 0 ? positive : negative;
    return with(std::move(out), cells, right);
}

CellVerdicts judged_again(CellVerdicts before, const Lattice& now, std::span<const PointMove> moves,
                          const GuardOptions& options)
{
    const CellGrid grid(now.displacement.axes);
    assert(before.of.size() == grid.count());
    const std::vector<int> cells = not_excepted(grid, grid.touched(moves), options);
    const int sign = before.sign;
    return with(std::move(before), cells, judged(grid, now, cells, sign, options));
}

std::vector<PointMove> scaled(std::span<const PointMove> moves, double share)
{
    std::vector<PointMove> out(moves.begin(), moves.end());
    for (PointMove& move : out) move.by *= share;
    return out;
}

CertifiedShare certified_share(const Lattice& from, const CellVerdicts& before,
                               std::span<const PointMove> moves, const GuardOptions& options)
{
    assert(options.steps > 0);
    const CellGrid grid(from.displacement.axes);
    assert(before.of.size() == grid.count());
    const std::vector<int> cells = not_excepted(grid, grid.touched(moves), options);
    Lattice trial = from;
    const auto judged_at = [&](const std::vector<int>& which, int step) {
        Trivariate<glm::dvec3>& d = trial.displacement;
        const auto index = [&](const PointMove& m) {
            return d.index(m.index.x, m.index.y, m.index.z);
        };
        for (const PointMove& move : moves)
            d.points[index(move)] = from.displacement.points[index(move)];
        for (const PointMove& move : scaled(moves, static_cast<double>(step) / options.steps))
            d.points[index(move)] += move.by;
        return judged(grid, trial, which, before.sign, options);
    };
    const auto forbids = [&](int cell, const Judged& now) {
        const auto c = static_cast<std::size_t>(cell);
        return !allowed({before.of[c], before.least[c]}, now);
    };

    // All cells are judged at the largest share not yet forbidden; the worst of those that forbid
    // it is asked alone how far it lets them go, until none forbids.
    CertifiedShare out;
    out.after = before;
    for (int step = options.steps; step > 0;) {
        const std::vector<Judged> now = judged_at(cells, step);
        std::vector<int> stopping;
        int worst = -1;
        double least = 0;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (forbids(cells[i], now[i])) {
                if (stopping.empty() || now[i].least < least) {
                    worst = cells[i];
                    least = now[i].least;
                }
                stopping.push_back(cells[i]);
            }
        out.share = static_cast<double>(step) / options.steps;
        if (stopping.empty()) {
            out.after = with(before, cells, now);
            return out;
        }
        out.stopping = std::move(stopping);
        int low = 0;
        while (step - low > 1) {
            const int middle = low + (step - low) / 2;
            (forbids(worst, judged_at({worst}, middle).front()) ? step : low) = middle;
        }
        step = low;
    }
    out.share = 0;
    return out;
}

double certified_share(const Lattice& from, std::span<const PointMove> moves,
                       const GuardOptions& options)
{
    return certified_share(from, judge(from, options), moves, options).share;
}

} // namespace trivar
