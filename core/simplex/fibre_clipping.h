// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/fibre_piece.h"

#include <algorithm>

namespace trivar {

// A FibreVolume is the volume of { mu >= 0, l - B mu >= 0 } in N dimensions, N = 1..3, with the
// size of its facet in each plane row_k(B) mu = l_k divided by |row_k(B)|: its derivative by l_k.
// `on_edge` tells that a plane passes along one of its faces to 1e-12, where that derivative may
// jump.
template <int K> struct FibreVolume {
    double volume = 0;
    std::array<double, K> facet{};
    bool on_edge = false;
};

namespace fibre_detail {

template <int N, int K> class Clipping {
public:
    using Rows = std::array<glm::vec<N, double>, K>;

    Clipping(const std::array<double, K>& l, const Rows& rows, bool facets)
        : l_(l),
          rows_(rows),
          facets_(facets)
    {
        for (std::size_t k = 0; k < K; ++k) {
            double least = l[k], most = l[k]; // at the corners of the whole simplex
            for (int i = 0; i < N; ++i) {
                least = std::min(least, l[k] - rows[k][i]);
                most = std::max(most, l[k] - rows[k][i]);
            }
            empty_ = empty_ || most < 0;
            if (least < 1e-12) needed_[count_++] = k;
        }
    }

    void whole()
    {
        Piece<N> all{};
        for (int i = 0; i < N; ++i) all[static_cast<std::size_t>(i) + 1].mu[i] = 1;
        if (!empty_) clip(0, all);
    }

    FibreVolume<K> out;

private:
    void clip(std::size_t step, const Piece<N>& piece)
    {
        std::array<double, N + 1> f;
        int inside = 0;
        for (; step < count_; ++step) {
            const std::size_t row = needed_[step];
            inside = 0;
            int on = 0;
            for (std::size_t i = 0; i <= N; ++i) {
                f[i] = l_[row] - glm::dot(rows_[row], piece[i].mu);
                inside += f[i] >= 0 ? 1 : 0;
                on += std::abs(f[i]) < 1e-12 ? 1 : 0;
            }
            if (facets_ && on >= N) out.on_edge = true;
            if (inside == 0) return;
            if (inside <= N) break;
        }
        if (step == count_)
            add(piece);
        else
            cut(step, piece, f, inside);
    }

    // A simplex has at most two kinds of corners, so what is inside is a simplex or a prism: of the
    // corners inside times the points on the edges to those outside.
    void cut(std::size_t step, const Piece<N>& piece, const std::array<double, N + 1>& f,
             int inside)
    {
        std::array<std::size_t, N + 1> order;
        std::size_t in = 0, behind = static_cast<std::size_t>(inside);
        for (std::size_t i = 0; i <= N; ++i) order[f[i] >= 0 ? in++ : behind++] = i;
        const auto point = [&](std::size_t a, std::size_t b) {
            const Corner<N>&p = piece[order[a]], &q = piece[order[b]];
            const double t = f[order[a]] / (f[order[a]] - f[order[b]]);
            return Corner<N>{p.mu + (q.mu - p.mu) * t, (p.planes & q.planes) | 1U << needed_[step]};
        };
        const auto p = static_cast<std::size_t>(inside);
        if (p == 1) {
            Piece<N> tip{piece[order[0]]};
            for (std::size_t b = 1; b <= N; ++b) tip[b] = point(0, b);
            return clip(step + 1, tip);
        }
        // the prism with the ends A and B, as N simplices that climb from A to B
        std::array<Corner<N>, N> A, B;
        if (p == N) // all but one inside
            for (std::size_t i = 0; i < N; ++i) A[i] = piece[order[i]], B[i] = point(i, N);
        else // two and two, in space
            for (std::size_t i = 0; i < 2; ++i) {
                std::array<Corner<N>, N>& end = i == 0 ? A : B;
                end[0] = piece[order[i]];
                for (std::size_t j = 1; j < N; ++j) end[j] = point(i, 1 + j);
            }
        for (std::size_t n = 0; n < N; ++n) {
            Piece<N> each;
            for (std::size_t i = 0; i <= n; ++i) each[i] = A[i];
            for (std::size_t i = n; i < N; ++i) each[i + 1] = B[i];
            clip(step + 1, each);
        }
    }

    void add(const Piece<N>& piece)
    {
        out.volume += content(piece);
        if (!facets_) return;
        for (std::size_t opposite = 0; opposite <= N; ++opposite) {
            std::uint32_t common = ~0U;
            for (std::size_t i = 0; i <= N; ++i)
                if (i != opposite) common &= piece[i].planes;
            for (std::uint32_t k = 0; common != 0 && k < K; ++k)
                if ((common >> k & 1U) != 0) {
                    out.facet[k] += facet_content(piece, opposite) / glm::length(rows_[k]);
                    break;
                }
        }
    }

    const std::array<double, K>& l_;
    const Rows& rows_;
    bool facets_, empty_ = false;
    std::array<std::size_t, K> needed_{}; // the planes that cut the whole simplex
    std::size_t count_ = 0;
};

} // namespace fibre_detail

} // namespace trivar
