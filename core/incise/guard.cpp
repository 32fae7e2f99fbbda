// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace trivar {
namespace {

constexpr double narrower = 0.7, as_good_as_shut = 0.02; // shares
constexpr double least_share = 0.6; // of the move of the incision that moves a pair most
// Openings at which nothing may pierce where something was narrowed.
constexpr double half_open = 0.5; // where nothing was, but several pieces may meet
constexpr std::array looked_at{1.0, 0.75, 0.5, 0.25, 0.1};
constexpr double edges_of_dent = 1.2, widths_of_dent = 1;

} // namespace

CutGuard::CutGuard(const CutShape& shape)
{
    const CutSkin& skin = shape.drawing.skin();
    KeyNumbers local(shape.terms.size() + shape.walls.skin.size()); // about
    std::vector<std::uint32_t> vertices;
    const auto number = [&](std::uint32_t vertex) {
        const auto [n, fresh] = local.number(vertex);
        if (fresh) {
            vertices.push_back(vertex);
            rest_.push_back(shape.rest_position(vertex));
        }
        return n;
    };
    for (std::size_t i = 0; i < shape.walls.skin.size(); ++i) {
        const auto& t = shape.walls.skin[i];
        if (!shape.left_out.patch_piece(i))
            triangles_.emplace_back(number(t[0]), number(t[1]), number(t[2]));
    }
    first_wall_ = triangles_.size();
    for (std::uint32_t i = 0; i < shape.walls.walls.size(); ++i) {
        const WallTriangle& t = shape.walls.walls[i];
        if (shape.left_out.wall(i)) continue;
        triangles_.emplace_back(number(t.corners[0].vertex), number(t.corners[1].vertex),
                                number(t.corners[2].vertex));
        walls_.push_back(i);
    }
    end_of_walls_ = triangles_.size();
    for (const CutTerm& term : shape.terms) {
        terms_.push_back(term);
        terms_.back().vertex = number(term.vertex);
    }
    std::ranges::stable_sort(terms_, {}, &CutTerm::vertex);
    KeyNumbers taken(2 * shape.terms.size()); // triangles of the skin round all these vertices
    const std::size_t inner = vertices.size();
    for (std::size_t i = 0; i < inner; ++i) {
        if (vertices[i] >= skin.point_count()) continue;
        skin.around(vertices[i], [&](std::uint32_t side) {
            if (!taken.number(side / 3).second || shape.patch.replaces(side / 3)) return;
            if (std::ranges::binary_search(shape.left_out.skin, side / 3)) return;
            const glm::uvec3& t = skin.triangle(side / 3);
            triangles_.emplace_back(number(t.x), number(t.y), number(t.z));
        });
    }
}

std::vector<PiercingPair> CutGuard::piercings(std::span<const Admitted> admitted,
                                              double share) const
{
    std::vector<glm::dvec3> p = rest_;
    for (const CutTerm& term : terms_)
        p[term.vertex] += share *
                          admitted[term.incision].at(double{term.share}, double{term.below}) *
                          glm::dvec3(term.move);
    std::vector<char> moved(triangles_.size());
    for (std::size_t t = 0; t < moved.size(); ++t)
        for (int i = 0; i < 3; ++i) moved[t] |= p[triangles_[t][i]] != rest_[triangles_[t][i]];
    std::vector<PiercingPair> out = trivar::piercings(p, triangles_, moved);
    std::erase_if(out, [&](const PiercingPair& pair) {
        return pierce(rest_, triangles_[pair.a], triangles_[pair.b]);
    });
    return out;
}

std::vector<PiercingPair> CutGuard::piercings_when_shut() const
{
    std::vector<char> walls(triangles_.size(), 0);
    std::fill_n(walls.begin() + static_cast<std::ptrdiff_t>(first_wall_), walls_.size(), 1);
    return trivar::piercings(rest_, triangles_, walls);
}

// How much the incisions change the place of two triangles to each other: the greatest distance
// between their moves of the corners, by incision, ascending.
std::vector<CutGuard::Share> CutGuard::shares_of(const PiercingPair& pair,
                                                 std::span<const Admitted> admitted) const
{
    std::map<std::uint32_t, std::array<glm::dvec3, 6>> moves;
    for (std::size_t i = 0; i < 6; ++i)
        for (const CutTerm& term : terms_at(corner(pair, i))) {
            auto& of = moves.try_emplace(term.incision).first->second;
            of[i] += admitted[term.incision].at(double{term.share}, double{term.below}) *
                     glm::dvec3(term.move);
        }
    std::vector<Share> out;
    for (const auto& [incision, move] : moves) {
        double most = 0;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k < i; ++k)
                most = std::max(most, glm::distance(move[i], move[k]));
        out.push_back({incision, most});
    }
    return out;
}

std::vector<std::uint32_t> piercing_on_their_way(const CutShape& shape)
{
    const CutGuard guard(shape);
    std::vector<std::uint32_t> out;
    for (const PiercingPair& pair : guard.piercings_when_shut())
        for (const std::uint32_t t : {pair.a, pair.b}) {
            if (!guard.is_wall(t)) continue;
            const WallTriangle& wall = shape.walls.walls[guard.wall_number(t)];
            for (const SlitEdge::Pass& pass : shape.graph.edges[wall.corners[0].edge].passes) {
                const CutRun& run = shape.runs[shape.pieces[pass.piece].run];
                if (!run.has_floor()) out.push_back(run.incision);
            }
        }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

void CutGuard::narrow(std::span<const PiercingPair> pairs, std::span<const double> radius,
                      std::vector<Admitted>& admitted) const
{
    const std::vector<Admitted> before = admitted;
    for (const PiercingPair& pair : pairs) {
        const std::vector<Share> shares = shares_of(pair, before);
        double most = 0;
        for (const Share& share : shares) most = std::max(most, share.move);
        std::vector<const CutTerm*> terms; // of those that move the pair most
        for (std::size_t i = 0; i < 6; ++i)
            for (const CutTerm& term : terms_at(corner(pair, i)))
                if (std::ranges::find(shares, term.incision, &Share::incision)->move >=
                    least_share * most)
                    terms.push_back(&term);
        const auto lower = [&](const CutTerm& term, Narrowing Admitted::*what) {
            const double x = double{term.share};
            const double next = narrower * (before[term.incision].*what).at(x);
            (admitted[term.incision].*what)
                .narrow(x, next < as_good_as_shut ? 0 : next, radius[term.incision]);
        };
        // First what lies below the skin is drawn together
        std::vector<const CutTerm*> below = terms;
        std::erase_if(below, [&](const CutTerm* term) {
            return !(term->below > 0 && before[term->incision].below.at(double{term->share}) > 0);
        });
        for (const CutTerm* term : below) lower(*term, &Admitted::below);
        if (below.empty())
            for (const CutTerm* term : terms) lower(*term, &Admitted::opening);
    }
}

std::optional<std::vector<Admitted>> admissible_openings(const CutShape& shape,
                                                         std::span<const Incision> incisions)
{
    const CutGuard guard(shape);
    if (!guard.piercings_when_shut().empty()) return {};
    std::vector<Admitted> admitted(incisions.size());
    std::vector<double> radius(incisions.size(), 1);
    const double edge = shape.drawing.skin().usual_edge();
    for (const CutRun& run : shape.runs)
        radius[run.incision] =
            std::max(edges_of_dent * edge, widths_of_dent * incisions[run.incision].width) /
            run.length;
    const auto pierce_at = [&](double share) {
        const std::vector<PiercingPair> pairs = guard.piercings(admitted, share);
        if (pairs.empty()) return false;
        guard.narrow(pairs, radius, admitted);
        return true;
    };
    // Upright walls that are apart when quite and half open are so before, but for hardly any.
    const bool upright = std::ranges::all_of(shape.runs, [&](const CutRun& run) {
        const Incision& incision = incisions[run.incision];
        return run.has_floor() && incision.lean_deg == 0 && incision.bevel == 0;
    });
    const bool crosses = shape.pieces.size() > 1;
    if (!pierce_at(1) && upright && !(crosses && pierce_at(half_open))) return admitted;
    for (std::size_t i = 0; i < looked_at.size();) i = pierce_at(looked_at[i]) ? 0 : i + 1;
    return admitted;
}

} // namespace trivar
