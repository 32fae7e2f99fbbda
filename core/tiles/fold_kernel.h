// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"

#include <array>
#include <span>

namespace trivar {

// The determinant of the derivatives of T is A + B z + C z^2 with A = (P_x x P_y) . N,
// B = (P_x x N_y + N_x x P_y) . N and C = (N_x x N_y) . N, of degree 8 along both axes. A FoldNet
// holds their Bernstein coefficients [9 j + i] over a piece of the unit square, followed by zeros
// up to the width of a register.
struct FoldNet {
    static constexpr std::size_t count = 81, room = 88;
    std::array<double, room> a{}, b{}, c{};
};

// A FoldPiece bounds from which height on the determinant may be zero over a piece: `limit` is the
// least positive root of all coefficients, `corner` that of those at its corners, which are values
// of the determinant. Infinity: there is none; 0: one is not positive at the height 0.
struct FoldPiece {
    FoldNet net;
    double limit = 0, corner = 0;
    bool vanishes = false; // all coefficients are zero
};

// The whole patches of up to `most_folded` tiles; more of them at once cost little more than one,
// about 3 microseconds with AVX-512. Each tile gets the same bits alone, among others and on any
// processor: products and sums are not fused.
inline constexpr std::size_t most_folded = 8;
void fold_pieces(std::span<const TilePatch> patches, std::span<FoldPiece> out);

// The four quarters of a piece, by de Casteljau's algorithm. About 2 microseconds.
std::array<FoldPiece, 4> quarters(const FoldNet& net);

} // namespace trivar
