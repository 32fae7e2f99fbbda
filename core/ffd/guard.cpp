// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/guard.h"

#include "core/base/mistake.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace trivar {
namespace {

bool overlap(const CellGrid::Place& cell, const Box& box)
{
    return glm::all(glm::lessThan(cell.lo, box.hi)) && glm::all(glm::lessThan(box.lo, cell.hi));
}

// Returns the cells that are to be judged.
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

std::vector<int> without(std::vector<int> cells, std::vector<int> gone)
{
    std::ranges::sort(gone);
    std::erase_if(cells, [&](int cell) { return std::ranges::binary_search(gone, cell); });
    return cells;
}

std::vector<int> all_cells(const CellGrid& grid)
{
    std::vector<int> out(grid.count());
    std::iota(out.begin(), out.end(), 0);
    return out;
}

struct GuardJudgement {
    Verdict verdict = Verdict::unknown;
    double least = 0;
    bool worse = false; // than before, in some coefficient
};

// Floors say for each cell that is not good how far each coefficient of sign * det J is below 0; 0
// if it is not.
using Floors = std::map<int, std::vector<double>>;

Floors floors_of(const CellGrid& grid, const Lattice& lattice, const std::vector<int>& cells,
                 int sign)
{
    std::vector<std::vector<double>> found(cells.size());
    each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
        for (const double c : det.f.coefficients) found[i].push_back(std::min(0.0, sign * c));
    });
    Floors out;
    for (std::size_t i = 0; i < cells.size(); ++i) out[cells[i]] = std::move(found[i]);
    return out;
}

bool below(const CellDeterminant& det, int sign, const std::vector<double>& floor)
{
    for (std::size_t i = 0; i < floor.size(); ++i)
        if (!(sign * det.f.coefficients[i] >= floor[i])) return true;
    return false;
}

GuardJudgement judged(const CellGrid::Place& place, const CellDeterminant& det, int sign,
                      const GuardOptions& options)
{
    GuardJudgement out{verdict_at_once(det, sign),
                       std::isfinite(det.mean) ? sign > 0 ? det.least : -det.most : 0};
    if (out.verdict != Verdict::unknown) return out;
    out.verdict = Verdict::proven_good;
    for (const DoubtfulPart& part : doubtful_parts(place, det, sign, options.halving))
        if (out.verdict != Verdict::proven_bad) out.verdict = part.verdict;
    return out;
}

std::vector<GuardJudgement> judged(const CellGrid& grid, const Lattice& lattice,
                                   const std::vector<int>& cells, int sign,
                                   const GuardOptions& options, const Floors& floors = {})
{
    std::vector<GuardJudgement> out(cells.size());
    each_determinant(grid, lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
        out[i] = judged(grid.place(static_cast<std::size_t>(cells[i])), det, sign, options);
        if (const auto floor = floors.find(cells[i]); floor != floors.end())
            out[i].worse = below(det, sign, floor->second);
    });
    return out;
}

CellVerdicts with(CellVerdicts verdicts, const std::vector<int>& cells,
                  const std::vector<GuardJudgement>& judged)
{
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto cell = static_cast<std::size_t>(cells[i]);
        verdicts.of[cell] = judged[i].verdict;
        verdicts.least[cell] = judged[i].least;
    }
    return verdicts;
}

// A TriedMove is a move of control points that is tried in shares.
class TriedMove {
public:
    TriedMove(const Lattice& from, const CellVerdicts& before, std::span<const PointMove> moves,
              const GuardOptions& options)
        : from_(from),
          before_(before),
          moves_(moves),
          options_(options),
          grid_(from.displacement.axes),
          trial_(from)
    {
        ensure(options.steps > 0 && before.of.size() == grid_.count(),
               "verdicts are not of this lattice");
        std::vector<int> open;
        for (const int cell : touched())
            if (before.of[static_cast<std::size_t>(cell)] != Verdict::proven_good)
                open.push_back(cell);
        floors_ = floors_of(grid_, from, open, before.sign);
    }

    std::vector<int> touched() const
    {
        return not_excepted(grid_, grid_.touched(moves_), options_);
    }

    // Returns the touched cells at the site of the point that moves furthest, where the bending is
    // largest.
    std::vector<int> at_the_middle(const std::vector<int>& touched) const
    {
        const auto farthest = std::ranges::max_element(
            moves_, {}, [](const PointMove& m) { return glm::dot(m.by, m.by); });
        if (farthest == moves_.end()) return {};
        Box site;
        for (int a = 0; a < 3; ++a) {
            const Knots& axis = from_.displacement.axes[static_cast<std::size_t>(a)];
            const double at = axis.greville(farthest->index[a]);
            const double off = (axis.end() - axis.begin()) / (2.0 * grid_.size()[a]);
            site.lo[a] = at - off;
            site.hi[a] = at + off;
        }
        std::vector<int> out;
        for (const int cell : touched)
            if (overlap(grid_.place(static_cast<std::size_t>(cell)), site)) out.push_back(cell);
        return out;
    }

    void move_by(int step)
    {
        Trivariate<glm::dvec3>& d = trial_.displacement;
        const auto index = [&](const PointMove& m) {
            return d.index(m.index.x, m.index.y, m.index.z);
        };
        for (const PointMove& move : moves_)
            d.points[index(move)] = from_.displacement.points[index(move)];
        for (const PointMove& move : scaled(moves_, static_cast<double>(step) / options_.steps))
            d.points[index(move)] += move.by;
    }

    struct Answer {
        std::vector<GuardJudgement> judged;
        std::vector<int> forbidding; // worst first
    };
    // Judges the move at its present share. If a quick test rejects some cells, no others are
    // examined in detail.
    Answer answer(const std::vector<int>& cells) const
    {
        GuardOptions at_a_glance = options_;
        at_a_glance.halving = {0, 0, true};
        Answer out{judged(grid_, trial_, cells, before_.sign, at_a_glance, floors_), {}};
        out.forbidding = forbidding(cells, out.judged, true);
        if (!out.forbidding.empty()) return out;
        std::vector<int> doubtful;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (out.judged[i].verdict == Verdict::unknown) doubtful.push_back(cells[i]);
        const std::vector<GuardJudgement> closely =
            judged(grid_, trial_, doubtful, before_.sign, options_, floors_);
        for (std::size_t i = 0, next = 0; i < cells.size(); ++i)
            if (out.judged[i].verdict == Verdict::unknown) out.judged[i] = closely[next++];
        out.forbidding = forbidding(cells, out.judged, false);
        return out;
    }

    // Finds by bisection the largest step below `step` that the cell allows, or 0. Judges this cell
    // alone.
    int allowed_by(int cell, int step)
    {
        int low = 0;
        while (step - low > 1) {
            const int middle = low + (step - low) / 2;
            move_by(middle);
            const GuardJudgement now =
                judged(grid_, trial_, {cell}, before_.sign, options_, floors_).front();
            (allows(cell, now) ? low : step) = middle;
        }
        return low;
    }

private:
    // Says whether a move is allowed: good cells stay good; others become good, or get worse in no
    // coefficient.
    bool allows(int cell, const GuardJudgement& now) const
    {
        if (now.verdict == Verdict::proven_good) return true;
        const Verdict before = before_.of[static_cast<std::size_t>(cell)];
        return before != Verdict::proven_good && !now.worse &&
               !(before == Verdict::unknown && now.verdict == Verdict::proven_bad);
    }
    std::vector<int> forbidding(const std::vector<int>& cells,
                                const std::vector<GuardJudgement>& now, bool surely) const
    {
        std::vector<int> out;
        double least = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if ((surely && now[i].verdict != Verdict::proven_bad) || allows(cells[i], now[i]))
                continue;
            out.push_back(cells[i]);
            if (out.size() > 1 && !(now[i].least < least)) continue;
            least = now[i].least;
            std::swap(out.front(), out.back());
        }
        return out;
    }

    const Lattice& from_;
    const CellVerdicts& before_;
    std::span<const PointMove> moves_;
    const GuardOptions& options_;
    CellGrid grid_;
    Lattice trial_;
    Floors floors_; // of touched cells that are not good
};

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
    // The right sign may be known only after all cells have been examined.
    std::vector<GuardJudgement> positive(cells.size()), negative(cells.size());
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
    out.sign = options.sign != 0 ? options.sign : volume < 0 ? -1 : 1;
    if (size > 0 && std::isfinite(volume)) out.typical = std::abs(volume) / size;
    const std::vector<GuardJudgement>& right = out.sign > 0 ? positive : negative;
    return with(std::move(out), cells, right);
}

CellVerdicts judged_again(CellVerdicts before, const Lattice& now, std::span<const PointMove> moves,
                          const GuardOptions& options)
{
    const CellGrid grid(now.displacement.axes);
    ensure(before.of.size() == grid.count(), "verdicts are not of this lattice");
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
    TriedMove move(from, before, moves, options);
    // The cells that forbade a share are asked first about a smaller one, the others only if these
    // allow it.
    const std::vector<int> touched = move.touched();
    std::vector<int> suspects = move.at_the_middle(touched), others = without(touched, suspects);
    CertifiedShare out;
    out.after = before;
    for (int step = options.steps; step > 0;) {
        out.share = static_cast<double>(step) / options.steps;
        move.move_by(step);
        const TriedMove::Answer first = move.answer(suspects);
        std::vector<int> forbidding = first.forbidding;
        if (forbidding.empty()) {
            const TriedMove::Answer then = move.answer(others);
            if (then.forbidding.empty()) {
                out.after = with(with(before, suspects, first.judged), others, then.judged);
                return out;
            }
            forbidding = then.forbidding;
            others = without(std::move(others), forbidding);
            suspects.insert(suspects.end(), forbidding.begin(), forbidding.end());
        }
        step = move.allowed_by(forbidding.front(), step);
        out.stopping = std::move(forbidding);
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
