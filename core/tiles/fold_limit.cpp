// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/fold_limit.h"

#include "core/tiles/fold_kernel.h"

#include <algorithm>
#include <limits>

namespace trivar {
namespace {

// If each Bernstein coefficient of A + B z + C z^2 is positive for all z up to a height, so is the
// determinant: the limit is the least positive root of the coefficients, which are quadratic in z.

constexpr double infinity = std::numeric_limits<double>::infinity();

struct OpenPiece {
    double limit;
    std::size_t at; // of `pieces`
};

// Quarters the piece with the lowest limit until that is nearly a value at a corner, which no limit
// can be above. `pieces` is room for the work.
double limit_of(const FoldPiece& whole, int most_quartered, std::vector<FoldNet>& pieces)
{
    if (whole.vanishes) return 0;
    const auto higher = [](const OpenPiece& x, const OpenPiece& y) { return x.limit > y.limit; };
    pieces.assign(1, whole.net);
    std::vector<OpenPiece> heap{{whole.limit, 0}};
    double corner = whole.corner;
    for (int i = 0; i < most_quartered; ++i) {
        const double limit = heap.front().limit;
        if (limit == infinity || limit >= 0.995 * corner) break;
        std::ranges::pop_heap(heap, higher);
        const std::size_t lowest = heap.back().at;
        heap.pop_back();
        for (const FoldPiece& part : quarters(pieces[lowest])) {
            corner = std::min(corner, part.corner);
            heap.push_back({part.limit, pieces.size()});
            pieces.push_back(part.net);
            std::ranges::push_heap(heap, higher);
        }
    }
    return heap.front().limit;
}

} // namespace

double fold_limit(const TilePatch& patch, int most_quartered)
{
    return fold_limits({&patch, 1}, most_quartered).front();
}

std::vector<double> fold_limits(std::span<const TilePatch> patches, int most_quartered)
{
    std::vector<double> out;
    out.reserve(patches.size());
    std::array<FoldPiece, most_folded> whole;
    std::vector<FoldNet> pieces;
    for (std::size_t i = 0; i < patches.size(); i += most_folded) {
        const std::size_t count = std::min(most_folded, patches.size() - i);
        fold_pieces(patches.subspan(i, count), std::span(whole).first(count));
        for (std::size_t k = 0; k < count; ++k)
            out.push_back(limit_of(whole[k], most_quartered, pieces));
    }
    return out;
}

} // namespace trivar
