// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

double signed_least(const Bernstein& f, int sign)
{
    const double* x = f.coefficients.data();
    const std::size_t n = f.coefficients.size();
    const double factor = sign;
    // Four independent minima let the processor work in parallel.
    std::array<double, 4> least;
    least.fill(factor * *x);
    for (std::size_t i = 0; i + 4 <= n; i += 4)
        for (std::size_t j = 0; j < 4; ++j) least[j] = std::min(least[j], factor * x[i + j]);
    for (std::size_t i = n - n % 4; i < n; ++i) least[0] = std::min(least[0], factor * x[i]);
    return *std::ranges::min_element(least);
}

bool bad_at_a_corner(const Bernstein& f, int sign, double doubt)
{
    const std::size_t nv = static_cast<std::size_t>(f.degree[1]) + 1,
                      nw = static_cast<std::size_t>(f.degree[2]) + 1;
    for (const std::size_t i : {std::size_t{0}, f.coefficients.size() / (nv * nw) - 1})
        for (const std::size_t j : {std::size_t{0}, nv - 1})
            for (const std::size_t k : {std::size_t{0}, nw - 1})
                if (sign * f.coefficients[(i * nv + j) * nw + k] < -doubt) return true;
    return false;
}

// Says whether det J is bad at the site of its least coefficient, near which it is often least.
bool bad_at_the_least(const Bernstein& f, double signed_least, int sign, double doubt)
{
    const auto found = std::ranges::find(f.coefficients, sign * signed_least);
    const auto least = static_cast<std::size_t>(found - f.coefficients.begin());
    const std::size_t nv = static_cast<std::size_t>(f.degree[1]) + 1,
                      nw = static_cast<std::size_t>(f.degree[2]) + 1;
    const glm::dvec3 at(least / nw / nv, least / nw % nv, least % nw);
    return sign * value(f, at / glm::dvec3(f.degree[0], f.degree[1], f.degree[2])) < -doubt;
}

} // namespace

Verdict verdict_at_once(const CellDeterminant& det, int sign)
{
    if (!std::isfinite(det.mean) || !std::isfinite(det.doubt)) return Verdict::unknown;
    if ((sign > 0 ? det.least : -det.most) > det.doubt) return Verdict::proven_good;
    return bad_at_a_corner(det.f, sign, det.doubt) ? Verdict::proven_bad : Verdict::unknown;
}

std::vector<DoubtfulPart> doubtful_parts(const CellGrid::Place& cell, const CellDeterminant& det,
                                         int sign, const Halving& halving)
{
    struct Piece {
        Bernstein f;
        double least;
        glm::dvec3 lo, hi;
        int halvings;
    };
    if (!std::isfinite(det.mean) || !std::isfinite(det.doubt))
        return {{cell.lo, cell.hi, Verdict::unknown}};
    std::vector<DoubtfulPart> out;
    std::vector<Piece> open{{det.f, signed_least(det.f, sign), cell.lo, cell.hi, 0}};
    for (int used = 0; !open.empty(); ++used) {
        const Piece part = std::move(open.back());
        open.pop_back();
        if (part.least > det.doubt) continue;
        const bool bad =
            bad_at_a_corner(part.f, sign, det.doubt) ||
            (halving.until_bad && bad_at_the_least(part.f, part.least, sign, det.doubt));
        if (bad || part.halvings == 3 * halving.depth || used >= halving.boxes) {
            out.push_back({part.lo, part.hi, bad ? Verdict::proven_bad : Verdict::unknown});
            if (bad && halving.until_bad) return out;
            continue;
        }
        const int axis = part.halvings % 3;
        std::array<Bernstein, 2> half = halves(part.f, static_cast<std::size_t>(axis));
        const double middle = (part.lo[axis] + part.hi[axis]) / 2;
        std::array<Piece, 2> next;
        for (std::size_t i = 0; i < 2; ++i) {
            const double least = signed_least(half[i], sign);
            next[i] = {std::move(half[i]), least, part.lo, part.hi, part.halvings + 1};
        }
        next[0].hi[axis] = next[1].lo[axis] = middle;
        if (next[0].least < next[1].least) std::swap(next[0], next[1]);
        for (Piece& p : next) open.push_back(std::move(p));
    }
    return out;
}

} // namespace trivar
