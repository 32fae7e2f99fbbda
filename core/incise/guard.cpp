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
// Openings at which nothing may pierce.
constexpr std::array looked_at{1.0, 0.9, 0.8, 0.75, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.1};
constexpr std::array quite_open{1.0};
constexpr std::array quite_and_half_open{1.0, 0.5};
constexpr double edges_of_dent = 1.2, widths_of_dent = 1;

} // namespace

CutGuard::CutGuard(const CutShape& shape, std::span<const Incision> incisions)
    : radius_(incisions.size(), 1),
      round_(incisions.size(), 0)
{
    const CutSkin& skin = shape.drawing.skin();
    KeyNumbers local(shape.terms.size() + shape.walls.skin.size()); // about
    std::vector<std::uint32_t> vertices;
    const auto number = [&](std::uint32_t vertex) {
        const auto [n, fresh] = local.number(vertex);
        if (fresh) {
            vertices.push_back(vertex);
            rest_.emplace_back(glm::vec3(shape.rest_position(vertex)));
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
    const double edge = skin.usual_edge();
    simple_ = shape.pieces.size() == 1;
    for (const CutRun& run : shape.runs) {
        const Incision& incision = incisions[run.incision];
        simple_ = simple_ && run.has_floor() && incision.lean_deg == 0 && incision.bevel == 0;
        radius_[run.incision] =
            std::max(edges_of_dent * edge, widths_of_dent * incisions[run.incision].width) /
            run.length;
        round_[run.incision] = run.closed();
    }
}

std::vector<PiercingPair> CutGuard::piercings(std::span<const Admitted> admitted,
                                              std::span<const double> shares) const
{
    std::vector<std::vector<glm::dvec3>> times(shares.size(),
                                               std::vector(rest_.size(), glm::dvec3(0)));
    for (const CutTerm& term : terms_) {
        const auto let =
            static_cast<float>(admitted[term.incision].at(double{term.share}, double{term.below}));
        const glm::dvec3 move(term.move * let);
        for (std::size_t i = 0; i < shares.size(); ++i) times[i][term.vertex] += shares[i] * move;
    }
    for (std::vector<glm::dvec3>& each : times)
        for (std::size_t v = 0; v < rest_.size(); ++v) each[v] += rest_[v];
    std::vector<char> moved(triangles_.size(), 0);
    for (std::size_t t = 0; t < moved.size(); ++t)
        for (int i = 0; i < 3; ++i)
            moved[t] |= times.front()[triangles_[t][i]] != rest_[triangles_[t][i]];
    std::vector<PiercingPair> out = trivar::piercings(times, triangles_, moved);
    std::erase_if(out, [&](const PiercingPair& pair) {
        return pierce(rest_, triangles_[pair.a], triangles_[pair.b]);
    });
    return out;
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

std::vector<std::uint32_t> CutGuard::walls_in_the_way() const
{
    std::vector<std::uint32_t> out;
    std::vector<char> walls(triangles_.size(), 0);
    std::fill_n(walls.begin() + static_cast<std::ptrdiff_t>(first_wall_), walls_.size(), 1);
    for (const PiercingPair& pair : trivar::piercings(rest_, triangles_, walls))
        for (const std::uint32_t t : {pair.a, pair.b})
            if (is_wall(t)) out.push_back(walls_[t - first_wall_]);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

void CutGuard::narrow(std::span<const PiercingPair> pairs, double dent,
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
                .narrow(x, next < as_good_as_shut ? 0 : next, dent * radius_[term.incision],
                        round_[term.incision] != 0);
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

bool CutGuard::admits_all() const
{
    // Upright walls of one piece that are apart when quite and half open are so before
    const std::vector<Admitted> all(radius_.size());
    return simple_ ? piercings(all, quite_and_half_open).empty()
                   : piercings(all, looked_at).empty();
}

std::vector<Admitted> CutGuard::admitted(double dent) const
{
    std::vector<Admitted> out(radius_.size());
    for (bool holds = false; !holds;) { // ends, as what moves nothing any more pierces nothing
        std::vector<PiercingPair> pairs = piercings(out, quite_open);
        if (pairs.empty()) pairs = piercings(out, looked_at);
        holds = pairs.empty();
        narrow(pairs, dent, out);
    }
    return out;
}

} // namespace trivar
