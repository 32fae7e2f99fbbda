// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/repair.h"

#include "core/ffd/repair_ways.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace trivar {
namespace {

std::vector<PointMove> one_pass(const RepairAttempt& attempt, const RepairSite& site,
                                const Lattice& lattice, const CellVerdicts& verdicts,
                                std::span<const int> once_doubtful, int pass)
{
    switch (attempt.way) {
    case RepairWay::smoothed_directions: return smoothed_directions(site, lattice, verdicts);
    case RepairWay::lowered_heights: return lowered_heights(site, lattice, verdicts, pass);
    case RepairWay::monotone_columns: return monotone_columns(site, lattice, verdicts, pass);
    case RepairWay::evened: return evened(site, lattice, verdicts, attempt.ground_yields);
    default: return relaxed(site, lattice, verdicts, once_doubtful, pass, attempt.ground_yields);
    }
}

// Returns the largest number of passes of a way. More would do harm: columns of a twentieth of
// their height, gaps of two thirds of a layer.
int most_passes(RepairWay way, const RepairOptions& options)
{
    return way == RepairWay::lowered_heights    ? std::min(options.passes, 40)
           : way == RepairWay::monotone_columns ? std::min(options.passes, 6)
                                                : options.passes;
}

// Returns the moves of the points that differ between two lattices.
std::vector<PointMove> difference(const RepairSite& site, const Lattice& from, const Lattice& to)
{
    std::vector<PointMove> out;
    for (std::size_t p = 0; p < from.displacement.points.size(); ++p)
        if (const glm::dvec3 by = to.displacement.points[p] - from.displacement.points[p];
            by != glm::dvec3(0))
            out.push_back({site.index(p), by});
    return out;
}

// Finds by bisection the least of sixteen shares of the moves that is good; each share is judged as
// it is returned.
std::vector<PointMove> as_few_as_do(const Lattice& folded, const CellVerdicts& before,
                                    std::vector<PointMove> moves, const GuardOptions& options)
{
    constexpr int steps = 16;
    int low = 0, high = steps;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        const auto part = scaled(moves, static_cast<double>(middle) / steps);
        (judged_again(before, moved(folded, part), part, options).good() ? high : low) = middle;
    }
    return high == steps ? moves : scaled(moves, static_cast<double>(high) / steps);
}

double rms(const std::vector<PointMove>& moves, std::size_t points)
{
    double squares = 0;
    for (const PointMove& move : moves) squares += glm::dot(move.by, move.by);
    return std::sqrt(squares / static_cast<double>(points));
}

// A way is given up after this number of passes without fewer doubtful cells.
constexpr int patience = 16;
// A way is also given up if it moves points this many times further than another one.
constexpr double excess = 4;

struct AttemptMoves {
    RepairAttempt attempt;
    std::vector<PointMove> moves;
};

AttemptMoves attempted(const RepairAttempt& how, const RepairSite& site, const Lattice& folded,
                       const CellVerdicts& before, double best, const Progress& progress)
{
    const RepairOptions& options = site.options();
    GuardOptions quick = options.guard;
    quick.halving.boxes = std::min(quick.halving.boxes, 32);
    Lattice now = folded;
    CellVerdicts verdicts = before;
    std::vector<int> once_doubtful;
    std::size_t fewest = before.of.size();
    int since = 0;
    const int passes = most_passes(how.way, options);
    for (int pass = 0; pass < passes; ++pass) {
        report(progress, static_cast<double>(pass) / passes, "mending");
        const std::vector<int> doubtful = doubtful_cells(verdicts);
        since = doubtful.size() < fewest ? 0 : since + 1;
        fewest = std::min(fewest, doubtful.size());
        if (doubtful.empty() || since > patience ||
            rms(difference(site, folded, now), folded.displacement.points.size()) > excess * best)
            break;
        std::vector<int> both;
        std::set_union(doubtful.begin(), doubtful.end(), once_doubtful.begin(), once_doubtful.end(),
                       std::back_inserter(both));
        once_doubtful = std::move(both);
        const std::vector<PointMove> moves =
            one_pass(how, site, now, verdicts, once_doubtful, pass);
        if (moves.empty()) break;
        now = moved(std::move(now), moves);
        verdicts = judged_again(std::move(verdicts), now, moves, quick);
    }
    AttemptMoves out{how, difference(site, folded, now)};
    // Differences are rounded and some cells were judged quickly, so that the result is judged
    // again.
    out.attempt.certified =
        judged_again(before, moved(folded, out.moves), out.moves, options.guard).good();
    if (out.attempt.certified)
        out.moves = as_few_as_do(folded, before, std::move(out.moves), options.guard);
    out.attempt.moved_rms = rms(out.moves, folded.displacement.points.size());
    for (const PointMove& move : out.moves)
        out.attempt.moved_most = std::max(out.attempt.moved_most, glm::length(move.by));
    return out;
}

} // namespace

UnfoldedLattice unfolded(const Lattice& lattice, const RepairOptions& options,
                         const Progress& progress)
{
    UnfoldedLattice out{lattice, false, {}, {}, {}};
    const CellVerdicts before = judge(lattice, options.guard);
    out.certified = before.good();
    if (out.certified || !(before.typical > 0)) return out;
    const RepairSite site(lattice, options);
    std::vector<RepairWay> ways{RepairWay::evened, RepairWay::relaxed};
    const Closure closure =
        lattice.displacement.axes[static_cast<std::size_t>(options.column_axis)].closure();
    if (closure == Closure::open)
        ways.insert(ways.end(), {RepairWay::monotone_columns, RepairWay::smoothed_directions,
                                 RepairWay::lowered_heights});
    const double most_ways = static_cast<double>(ways.size()) + 2;
    double tried = 0;
    const auto attempt = [&](RepairWay way, bool ground_yields) {
        AttemptMoves next =
            attempted({way, ground_yields}, site, lattice, before,
                      out.certified ? out.taken.moved_rms : 1e300,
                      part_of(progress, tried / most_ways, (tried + 1) / most_ways));
        ++tried;
        out.tried.push_back(next.attempt);
        if (!next.attempt.certified ||
            (out.certified && !(next.attempt.moved_rms < out.taken.moved_rms)))
            return;
        out.certified = true;
        out.taken = next.attempt;
        out.moves = std::move(next.moves);
    };
    for (const RepairWay way : ways) attempt(way, false);
    if (!out.certified)
        for (const RepairWay way : {RepairWay::evened, RepairWay::relaxed}) attempt(way, true);
    if (out.certified) out.lattice = moved(lattice, out.moves);
    return out;
}

} // namespace trivar
