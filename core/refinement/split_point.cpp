// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/split_point.h"

#include "core/base/index.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Pieces = std::vector<ErrorBounds::EdgePiece>;
using Chord = std::array<ErrorBounds::Corner, 2>;

double off_chord(const glm::dvec4& p, const Chord& edge, double t)
{
    return glm::distance(glm::dvec3(p), glm::mix(edge[0].displacement, edge[1].displacement, t));
}

double furthest_control_point(const Pieces& pieces, const Chord& edge)
{
    double most = 0, at_t = 0.5;
    for (const ErrorBounds::EdgePiece& piece : pieces)
        for (int i = 0; i <= piece.degree; ++i) {
            const double t = piece.from + (piece.to - piece.from) * i / piece.degree;
            const double off = off_chord(piece.net[at(i)], edge, t);
            if (off > most) {
                most = off;
                at_t = t;
            }
        }
    return at_t;
}

glm::dvec4 value_on(const ErrorBounds::EdgePiece& piece, double t)
{
    auto p = piece.net;
    for (int n = piece.degree; n > 0; --n)
        for (int i = 0; i < n; ++i) p[at(i)] = glm::mix(p[at(i)], p[at(i + 1)], t);
    return p[0];
}

double furthest_point(const Pieces& pieces, const Chord& edge)
{
    constexpr int samples = 64; // over the whole edge, besides the ends of the pieces
    double most = 0, at_t = 0.5;
    for (const ErrorBounds::EdgePiece& piece : pieces) {
        const int steps =
            std::max(1, static_cast<int>(std::ceil(samples * std::abs(piece.to - piece.from))));
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps,
                         t = piece.from + (piece.to - piece.from) * share;
            const double off = off_chord(value_on(piece, share), edge, t);
            if (off > most) {
                most = off;
                at_t = t;
            }
        }
    }
    return at_t;
}

// Returns the slope of a piece at its start (0) or its end (1), by the parameter of the edge.
glm::dvec4 end_slope(const ErrorBounds::EdgePiece& piece, int end)
{
    const int i = end == 0 ? 0 : piece.degree - 1;
    return (piece.net[at(i + 1)] - piece.net[at(i)]) * (piece.degree / (piece.to - piece.from));
}

// Finds the point that halves the integral of |E''|^(1/2), by the control points of the second
// derivative. A kink that causes most of the error is itself the point.
double equal_halves(Pieces pieces)
{
    std::ranges::sort(pieces, {}, &ErrorBounds::EdgePiece::from);
    struct Strip {
        double from, to, weight;
    };
    std::vector<Strip> strips;
    double sum = 0, bend = 0, kink = 0, kink_at = 0.5;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        const ErrorBounds::EdgePiece& piece = pieces[n];
        const double width = piece.to - piece.from;
        if (!(width > 1e-9)) continue;
        const int count = piece.degree - 1;
        for (int i = 0; i < count; ++i) {
            const glm::dvec4 d =
                piece.net[at(i + 2)] - 2.0 * piece.net[at(i + 1)] + piece.net[at(i)];
            const double second = glm::length(d) * piece.degree * count / (width * width);
            const double step = width / count, weight = std::sqrt(second) * step;
            strips.push_back({piece.from + i * step, piece.from + (i + 1) * step, weight});
            sum += weight;
            bend = std::max(bend, second / 8);
        }
        if (n + 1 == pieces.size() || !(pieces[n + 1].to - pieces[n + 1].from > 1e-9)) continue;
        const double t = piece.to,
                     off = glm::distance(end_slope(piece, 1), end_slope(pieces[n + 1], 0)) * t *
                           (1 - t);
        if (off > kink) {
            kink = off;
            kink_at = t;
        }
    }
    if (kink > bend) return kink_at;
    double before = 0;
    for (const Strip& s : strips) {
        if (before + s.weight >= sum / 2 && s.weight > 0)
            return s.from + (s.to - s.from) * (sum / 2 - before) / s.weight;
        before += s.weight;
    }
    return 0.5;
}

} // namespace

double split_point(ErrorBounds& bounds, const Chord& edge, SplitPoint split)
{
    if (split == SplitPoint::midpoint) return 0.5;
    const Pieces pieces = bounds.edge_pieces(edge);
    const double t = split == SplitPoint::greville         ? furthest_control_point(pieces, edge)
                     : split == SplitPoint::greatest_error ? furthest_point(pieces, edge)
                                                           : equal_halves(pieces);
    return std::isfinite(t) ? std::clamp(t, 0.2, 0.8) : 0.5;
}

} // namespace trivar
