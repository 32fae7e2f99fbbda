// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/guard.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr double narrower = 0.7, narrower_below = 0.4, as_good_as_shut = 0.02; // shares
constexpr double hardly_lacks = 0.05;                                          // of an opening
constexpr std::size_t triangles_of_a_look = 16;   // of a pair, by what it costs
constexpr std::size_t looks_of_one_step = 25'000; // after so many it narrows by two, and so on
constexpr double shorter_dent = 0.35, so_much_wider = 0.7; // of what an opening lacks with others
// Openings at which nothing may pierce.
constexpr std::array looked_at{1.0, 0.9, 0.8, 0.75, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.1};
constexpr std::array quite_and_half_open{1.0, 0.5};
constexpr double edges_of_dent = 1.2, widths_of_dent = 1;

std::vector<char> changed(const std::vector<glm::dvec3>& before,
                          const std::vector<glm::dvec3>& after)
{
    std::vector<char> out(before.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = before[v] != after[v];
    return out;
}

} // namespace

SlitGuard::SlitGuard(const SlitShape& shape, std::span<const Incision> incisions)
    : incisions_(incisions),
      radius_(incisions.size(), 1),
      round_(incisions.size(), 0)
{
    const SlitSkin& skin = shape.drawing.skin();
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
    for (const SlitTerm& term : shape.terms) {
        terms_.push_back(term);
        terms_.back().vertex = number(term.vertex);
    }
    std::ranges::stable_sort(terms_, {}, &SlitTerm::vertex);
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
    for (const SlitRun& run : shape.runs) {
        const Incision& incision = incisions[run.incision];
        simple_ = simple_ && run.has_floor() && incision.lean_deg == 0 && incision.bevel == 0;
        radius_[run.incision] =
            run.as_share(std::max(edges_of_dent * edge, widths_of_dent * run.width));
        round_[run.incision] = run.goes_round();
        if (run.kind != SlitRun::Kind::far_side) parts_.push_back({run.incision, run.from, run.to});
    }
}

std::vector<glm::dvec3> SlitGuard::moves(std::span<const Admitted> admitted,
                                         std::span<const char> open) const
{
    std::vector<glm::dvec3> out(rest_.size(), glm::dvec3(0));
    for (const SlitTerm& term : terms_) {
        if (!open[term.incision]) continue;
        const auto let =
            static_cast<float>(admitted[term.incision].at(double{term.share}, double{term.below}));
        out[term.vertex] += glm::dvec3(term.move * let);
    }
    return out;
}

bool SlitGuard::pierces(const PiercingPair& pair, const std::vector<glm::dvec3>& quite) const
{
    glm::uvec3 second(3, 4, 5); // numbers of corners; a common one has its first
    for (std::uint32_t i = 0; i < 9; ++i)
        if (corner(pair, i / 3) == corner(pair, 3 + i % 3)) second[static_cast<int>(i % 3)] = i / 3;
    return std::ranges::any_of(looked_at, [&](double share) {
        std::array<glm::dvec3, 6> p;
        for (std::size_t i = 0; i < 6; ++i)
            p[i] = rest_[corner(pair, i)] + share * quite[corner(pair, i)];
        return pierce(p, {0, 1, 2}, second);
    });
}

std::vector<char> SlitGuard::moved_by(std::uint32_t incision) const
{
    std::vector<char> out(rest_.size(), 0);
    for (const SlitTerm& term : terms_)
        if (incision == any || term.incision == incision) out[term.vertex] = 1;
    return out;
}

std::vector<PiercingPair> SlitGuard::piercings(const std::vector<glm::dvec3>& quite,
                                               std::span<const double> shares,
                                               std::span<const char> moving) const
{
    std::vector<std::vector<glm::dvec3>> times(shares.size(), rest_);
    for (std::size_t i = 0; i < shares.size(); ++i)
        for (std::size_t v = 0; v < rest_.size(); ++v) times[i][v] += shares[i] * quite[v];
    std::vector<char> moved(triangles_.size(), 0);
    for (std::size_t t = 0; t < moved.size(); ++t)
        for (int i = 0; i < 3; ++i) moved[t] |= moving[triangles_[t][i]];
    std::vector<PiercingPair> out = trivar::piercings(times, triangles_, moved);
    looks_ += triangles_.size() / triangles_of_a_look + out.size();
    std::erase_if(out, [&](const PiercingPair& pair) {
        return pierce(rest_, triangles_[pair.a], triangles_[pair.b]);
    });
    return out;
}

std::vector<SlitGuard::Walls> SlitGuard::walls_in_the_way() const
{
    std::vector<Walls> out;
    std::vector<char> walls(triangles_.size(), 0);
    std::fill_n(walls.begin() + static_cast<std::ptrdiff_t>(first_wall_), walls_.size(), 1);
    for (const PiercingPair& pair : trivar::piercings(rest_, triangles_, walls)) {
        const std::uint32_t a = is_wall(pair.a) ? pair.a : pair.b,
                            b = is_wall(pair.b) ? pair.b : pair.a;
        if (is_wall(a)) out.push_back({walls_[a - first_wall_], walls_[b - first_wall_]});
    }
    return out;
}

double SlitGuard::lack(std::span<const Admission> admitted) const
{
    double sum = 0;
    for (std::uint32_t k = 0; k < admitted.size(); ++k) sum += lack(k, admitted[k].with_others);
    return sum;
}

double SlitGuard::lack(std::uint32_t incision, const Admitted& admitted) const
{
    double sum = 0;
    for (const Part& part : parts_)
        if (part.incision == incision)
            sum += 1 - admitted.opening.widest(incisions_[incision].opening_profile, part.from,
                                               part.to);
    return sum;
}

bool SlitGuard::admits_all() const
{
    // Upright walls of one piece that are apart when quite and half open are so before
    const std::vector<Admitted> all(radius_.size());
    const std::vector<char> open(radius_.size(), 1);
    const std::span<const double> shares =
        simple_ ? std::span<const double>(quite_and_half_open) : looked_at;
    return piercings(moves(all, open), shares, moved_by(any)).empty();
}

std::optional<std::vector<Admission>> SlitGuard::admitted(double most) const
{
    const auto count = static_cast<std::uint32_t>(radius_.size());
    std::vector<Admission> out(count);
    std::vector<Admitted> all(count);
    std::vector<char> open(count, 1);
    for (const PiercingPair& pair : piercings(moves(all, open), looked_at, moved_by(any)))
        for (std::size_t i = 0; i < 6; ++i)
            for (const SlitTerm& term : terms_at(corner(pair, i))) open[term.incision] = 0;
    for (std::uint32_t k = 0; k < count; ++k) { // one after the other beside those in no one's way
        if (open[k]) continue;
        open[k] = 1;
        out[k] = admitted(k, all, open);
        all[k] = out[k].with_others;
        if (lack(out) >= most) return std::nullopt;
    }
    std::vector<char> moving = moved_by(any);
    for (;;) { // what one of those that are open already kept apart
        const std::vector<glm::dvec3> quite = moves(all, open);
        const std::vector<PiercingPair> pairs = piercings(quite, looked_at, moving);
        if (pairs.empty()) return lack(out) < most ? std::optional(out) : std::nullopt;
        const std::vector<Admitted> before = all;
        std::vector<char> done(terms_.size(), 0);
        for (const PiercingPair& pair : pairs)
            for (std::uint32_t k = count; k-- > 0;)
                if (lower(pair, k, 1, before[k], all[k], done)) break;
        for (std::uint32_t k = 0; k < count; ++k) out[k].with_others = all[k];
        moving = changed(quite, moves(all, open));
    }
}

void SlitGuard::find_alone(std::vector<Admission>& admitted) const
{
    for (std::uint32_t k = 0; k < admitted.size(); ++k) {
        if (admitted[k].held_by.empty()) continue;
        std::vector<char> alone(admitted.size(), 0);
        alone[k] = 1;
        admitted[k].alone =
            this->admitted(k, std::vector<Admitted>(admitted.size()), alone).with_others;
    }
}

Admission SlitGuard::admitted(std::uint32_t incision, const std::vector<Admitted>& all,
                              std::span<const char> open) const
{
    Admission out;
    std::vector<char> holds(all.size(), 0);
    out.with_others = narrowed(incision, all, open, 1, holds);
    if (const double lacks = lack(incision, out.with_others); lacks > hardly_lacks)
        if (const Admitted other = narrowed(incision, all, open, shorter_dent, holds);
            lack(incision, other) < so_much_wider * lacks)
            out.with_others = other;
    out.alone = out.with_others;
    for (std::uint32_t k = 0; k < holds.size(); ++k)
        if (holds[k] && k != incision) out.held_by.push_back(k);
    return out;
}

Admitted SlitGuard::narrowed(std::uint32_t incision, std::vector<Admitted> all,
                             std::span<const char> open, double dent,
                             std::vector<char>& holds) const
{
    std::vector<glm::dvec3> quite = moves(all, open);
    std::vector<char> moving;
    // Tests the triangles that moved since the last test. False: the incision moves nothing that
    // pierces.
    const auto narrow = [&](std::span<const double> shares) {
        std::vector<PiercingPair> pairs = piercings(quite, shares, moving);
        const std::vector<glm::dvec3> before_all = quite;
        bool lowers = false;
        while (!pairs.empty()) { // these alone, before all are looked at again
            looks_ += pairs.size();
            const Admitted before = all[incision];
            std::vector<char> done(terms_.size(), 0);
            std::erase_if(pairs, [&](const PiercingPair& pair) {
                if (!lower(pair, incision, dent, before, all[incision], done)) return true;
                for (std::size_t i = 0; i < 6; ++i)
                    for (const SlitTerm& term : terms_at(corner(pair, i)))
                        if (open[term.incision]) holds[term.incision] = 1;
                return false;
            });
            lowers = lowers || !pairs.empty();
            quite = moves(all, open);
            std::erase_if(pairs, [&](const PiercingPair& pair) { return !pierces(pair, quite); });
        }
        moving = changed(before_all, quite);
        return lowers;
    };
    for (const std::span<const double> shares :
         {std::span<const double>(quite_and_half_open), std::span<const double>(looked_at)})
        for (moving = moved_by(incision); narrow(shares);) {
        } // what moves nothing pierces nothing
    return all[incision];
}

bool SlitGuard::lower(const PiercingPair& pair, std::uint32_t incision, double dent,
                      const Admitted& before, Admitted& after, std::vector<char>& done) const
{
    std::vector<const SlitTerm*> terms, below; // of the incision; and below the skin
    for (std::size_t i = 0; i < 6; ++i)
        for (const SlitTerm& term : terms_at(corner(pair, i))) {
            const double share{term.share}, depth{term.below};
            if (term.incision != incision || !(before.opening.at(share) > 0)) continue;
            terms.push_back(&term);
            if (depth > 0 && before.below.at(share) > 0) below.push_back(&term);
        }
    const auto steps = static_cast<double>(1 + looks_ / looks_of_one_step);
    const auto step = [&](const SlitTerm& term, Narrowing Admitted::*what, double factor) {
        char& known = done[static_cast<std::size_t>(&term - terms_.data())];
        const char bit = what == &Admitted::below ? 1 : 2;
        if ((known & bit) != 0) return;
        known = static_cast<char>(known | bit);
        const double x{term.share}, next = std::pow(factor, steps) * (before.*what).at(x);
        (after.*what)
            .narrow(x, next < as_good_as_shut ? 0 : next, dent * radius_[incision],
                    round_[incision] != 0);
    };
    // The part below the skin is drawn together first
    for (const SlitTerm* term : below) step(*term, &Admitted::below, narrower_below);
    if (below.empty())
        for (const SlitTerm* term : terms) step(*term, &Admitted::opening, narrower);
    return !terms.empty();
}

} // namespace trivar
