// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/trace.h"

#include "core/base/unit.h"
#include "core/incise/thinned_chain.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <queue>
#include <utility>

namespace trivar {
namespace {

using On = LatticePoint::On;

constexpr double attached = 0.15; // of the mean side of a triangle: points nearer become one
// A way over the skin that is longer than so many times the straight one, and so many edges, is no
// answer to a hand that was elsewhere at once: one that made so many of its usual steps in one.
constexpr double longest_way = 3, edges_of_way = 6, leap = 6;
constexpr int most_steps = 2000;          // across triangles, from one place to the next
constexpr std::size_t most_tries = 20000; // points that are looked at for a way along edges

double cosine(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::dot(a, b) / (glm::length(a) * glm::length(b) + 1e-300);
}

class Tracer {
public:
    explicit Tracer(const SlitDrawing& drawing) : drawing_(drawing), skin_(drawing.skin()) {}

    Traced operator()(std::span<const StrokePart> parts)
    {
        const double usual = usual_step(parts);
        for (const StrokePart& part : parts) draw(part, usual);
        std::vector<Line> lines = std::exchange(lines_, {});
        const char* touched = nullptr; // what ends a line
        for (const Line& line : lines) keep_sound_parts(line, touched);
        Traced out;
        for (Line& line : lines_) {
            DrawnChain chain = thinned(skin_, std::move(line.chain));
            if (chain.points.size() > 2) out.chains.push_back(std::move(chain));
        }
        if (out.chains.empty())
            out.refusal = touched ? std::string("it touches ") + touched
                          : std::ranges::all_of(
                                parts, [](const auto& part) { return part.places.size() < 2; })
                              ? "it leaves the surface"
                          : leapt_ ? "its points lie on parts of the surface that are not joined"
                                   : "it is shorter than a step of the surface";
        else if (out.chains.size() > 1)
            out.notice =
                fmt::format("it is cut in {} parts, as {}", out.chains.size(),
                            parts.size() > 1 || leapt_ ? "the surface does not go on between them"
                                                       : std::string("it touches ") + touched);
        else if (touched)
            out.notice = std::string("it ends before ") + touched;
        else if (out.chains[0].from > 0 || out.chains[0].to < 1)
            out.notice = "it ends where the surface does";
        return out;
    }

private:
    struct Line {
        DrawnChain chain;
        std::vector<double> shares; // of the stroke, by point; between places: not known, -1
    };

    // The median way from one place to the next.
    double usual_step(std::span<const StrokePart> parts) const
    {
        std::vector<double> steps;
        for (const StrokePart& part : parts)
            for (std::size_t i = 1; i < part.places.size(); ++i)
                steps.push_back(glm::distance(at(nearest_lattice_point(skin_, part.places[i - 1])),
                                              at(nearest_lattice_point(skin_, part.places[i]))));
        if (steps.empty()) return 0;
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::ranges::nth_element(steps, middle);
        return *middle;
    }

    void draw(const StrokePart& part, double usual)
    {
        std::vector<double> shares;
        const auto end = [&] {
            if (chain_.points.size() > 1) lines_.push_back({std::move(chain_), std::move(shares)});
            chain_ = {};
            shares.clear();
        };
        for (std::size_t i = 0; i < part.places.size(); ++i) {
            const LatticePoint to = attach(nearest_lattice_point(skin_, part.places[i]));
            if (!chain_.points.empty() && !(chain_.points.back() == to) && !go(to, usual)) {
                end();
                leapt_ = true;
            }
            if (chain_.points.empty()) chain_.points.push_back(to);
            const std::size_t known = shares.size();
            shares.resize(chain_.points.size(), -1);
            if (known != 1 || shares.size() > 1) shares.back() = part.share(i);
        }
        end();
    }

    // Over the skin to a point. False: it does not go on there. A hand that makes a step far beyond
    // its usual ones goes on where that is straight on, and jumps else.
    bool go(const LatticePoint& to, double usual)
    {
        const std::size_t begin = chain_.points.size() - 1;
        const double straight = glm::distance(at(chain_.points.back()), at(to));
        const double most = longest_way * straight + edges_of_way * skin_.usual_edge();
        const bool leaps = straight > leap * usual;
        if (!walk(to) && (leaps || !walk_along_edges(to, most))) return false;
        if (!leaps || way_from(begin) <= most) return true;
        chain_.points.resize(begin + 1);
        chain_.triangles.resize(begin);
        return false;
    }
    double way_from(std::size_t begin) const
    {
        double way = 0;
        for (std::size_t i = begin + 1; i < chain_.points.size(); ++i)
            way += glm::distance(at(chain_.points[i - 1]), at(chain_.points[i]));
        return way;
    }

    glm::dvec3 at(const LatticePoint& p) const { return position(skin_, p); }
    glm::dvec3 corner(std::uint32_t t, int i) const { return skin_.position(skin_.triangle(t)[i]); }
    double side_length(std::uint32_t side) const
    {
        return glm::distance(skin_.position(skin_.from(side)), skin_.position(skin_.to(side)));
    }

    LatticePoint attach(const LatticePoint& p) const
    {
        LatticePoint nearest = p;
        const glm::dvec3 x = at(p);
        double least = 1e300;
        for (const std::uint32_t t : triangles_round(skin_, p)) {
            double sides = 0;
            for (std::uint32_t i = 0; i < 3; ++i) sides += side_length(3 * t + i);
            const double within = attached * sides / 3;
            const auto look = [&](std::uint32_t number) {
                const double away = glm::distance(drawing_.position(number), x);
                if (away >= std::min(least, within)) return;
                least = away;
                nearest = drawing_.point(number);
            };
            for (std::uint32_t i = 0; i < 3; ++i)
                if (const auto* on = drawing_.on_edge(skin_.edge(3 * t + i)))
                    for (const SlitDrawing::OnEdge& each : *on) look(each.point);
            if (const auto* on = drawing_.on_triangle(t)) {
                for (const std::uint32_t number : on->points) look(number);
                for (const std::uint32_t s : on->segments) // those that are points of the skin
                    for (const std::uint32_t number :
                         {drawing_.segments()[s].a, drawing_.segments()[s].b})
                        look(number);
            }
        }
        return nearest;
    }

    glm::dvec3 normal_at(const LatticePoint& p) const
    {
        glm::dvec3 sum(0);
        for (const std::uint32_t t : triangles_round(skin_, p))
            sum += unit_or_zero(skin_.area_normal(t));
        return unit_or_zero(sum);
    }

    // The point at which the plane leaves a side, `share` of the way along it.
    LatticePoint exit_at(std::uint32_t side, double share) const
    {
        std::uint32_t lo = skin_.from(side), hi = skin_.to(side);
        if (lo > hi) {
            std::swap(lo, hi);
            share = 1 - share;
        }
        int steps = static_cast<int>(std::lround(share * lattice_steps));
        if (const auto* on = drawing_.on_edge(skin_.edge(side))) {
            const double step = side_length(side) / lattice_steps;
            double least = attached * side_length(side);
            const int asked = steps;
            for (const SlitDrawing::OnEdge& each : *on) {
                const double away = std::abs(each.steps - asked) * step;
                if (away >= least) continue;
                least = away;
                steps = each.steps;
            }
        }
        if (steps <= 0) return {On::point, lo, 0, 0};
        if (steps >= lattice_steps) return {On::point, hi, 0, 0};
        return {On::edge, skin_.edge(side), steps, 0};
    }

    bool walk(const LatticePoint& to)
    {
        const LatticePoint from = chain_.points.back();
        const std::size_t points = chain_.points.size(), triangles = chain_.triangles.size();
        const glm::dvec3 a = at(from), d = at(to) - a;
        const glm::dvec3 across = glm::cross(d, normal_at(from) + normal_at(to));
        LatticePoint x = from;
        std::uint32_t last = SlitSkin::none;
        std::vector<LatticePoint> seen{from};
        for (int step = 0; step < most_steps; ++step) {
            const std::vector<std::uint32_t> round = triangles_round(skin_, x);
            for (const std::uint32_t t : round)
                if (weights_in(skin_, to, t)) {
                    chain_.points.push_back(to);
                    chain_.triangles.push_back(t);
                    return true;
                }
            double best = 0;
            LatticePoint next;
            std::uint32_t through = SlitSkin::none;
            for (const std::uint32_t t : round) {
                if (t == last && x.on == On::edge) continue;
                for (std::uint32_t i = 0; i < 3; ++i) {
                    const std::uint32_t side = 3 * t + i, u = skin_.from(side), v = skin_.to(side);
                    if (x.on == On::point && (x.index == u || x.index == v)) continue;
                    if (x.on == On::edge && x.index == skin_.edge(side)) continue;
                    const double h_u = glm::dot(across, skin_.position(u) - a);
                    const double h_v = glm::dot(across, skin_.position(v) - a);
                    if ((h_u < 0) == (h_v < 0)) continue;
                    const LatticePoint y = exit_at(side, h_u / (h_u - h_v));
                    const double ahead = cosine(at(y) - at(x), d);
                    if (!(ahead > best) || std::ranges::count(seen, y) > 0) continue;
                    best = ahead;
                    next = y;
                    through = t;
                }
            }
            if (through == SlitSkin::none) break;
            chain_.points.push_back(next);
            chain_.triangles.push_back(through);
            seen.push_back(next);
            x = next;
            last = through;
        }
        chain_.points.resize(points);
        chain_.triangles.resize(triangles);
        return false;
    }

    // Where the plane loses its aim: the shortest way along edges, if it is no longer than `most`.
    bool walk_along_edges(const LatticePoint& to, double most)
    {
        struct Open {
            double far;
            std::uint32_t number;
            bool operator<(const Open& o) const
            {
                return far != o.far ? far > o.far : number > o.number;
            }
        };
        struct Reached {
            std::uint32_t point, before;
            double far;
            bool done = false;
        };
        std::priority_queue<Open> open;
        std::vector<Reached> reached;
        KeyNumbers number_of;
        const glm::dvec3 goal = at(to), start = at(chain_.points.back());
        const auto reach = [&](std::uint32_t point, std::uint32_t before, double far) {
            const auto [number, fresh] = number_of.number(point);
            if (fresh)
                reached.push_back({point, before, far});
            else if (far < reached[number].far)
                reached[number] = {point, before, far, reached[number].done};
            else
                return;
            open.push({far + glm::distance(goal, skin_.position(point)), number});
        };
        KeyNumbers ends;
        for (const std::uint32_t t : triangles_round(skin_, to))
            for (int i = 0; i < 3; ++i) ends.number(skin_.triangle(t)[i]);
        for (const std::uint32_t t : triangles_round(skin_, chain_.points.back()))
            for (int i = 0; i < 3; ++i)
                reach(skin_.triangle(t)[i], KeyNumbers::none, glm::distance(start, corner(t, i)));
        std::uint32_t end = KeyNumbers::none;
        for (std::size_t tries = 0; !open.empty() && tries < most_tries; ++tries) {
            const std::uint32_t number = open.top().number;
            if (open.top().far > most) break;
            open.pop();
            if (reached[number].done) continue;
            reached[number].done = true;
            const std::uint32_t point = reached[number].point;
            if (ends.contains(point)) {
                end = number;
                break;
            }
            const double far = reached[number].far;
            skin_.around(point, [&](std::uint32_t side) {
                for (const std::uint32_t other : {skin_.to(side), skin_.from(skin_.previous(side))})
                    reach(other, number,
                          far + glm::distance(skin_.position(point), skin_.position(other)));
            });
        }
        if (end == KeyNumbers::none) return false;
        std::vector<LatticePoint> way;
        for (std::uint32_t i = end; i != KeyNumbers::none; i = reached[i].before)
            way.push_back({On::point, reached[i].point, 0, 0});
        std::ranges::reverse(way);
        way.push_back(to);
        for (const LatticePoint& p : way)
            if (!append(p)) return false;
        return true;
    }
    bool append(const LatticePoint& p)
    {
        if (p == chain_.points.back()) return true;
        for (const std::uint32_t t : triangles_round(skin_, chain_.points.back()))
            if (weights_in(skin_, p, t)) {
                chain_.points.push_back(p);
                chain_.triangles.push_back(t);
                return true;
            }
        return false;
    }

    const char* unsound(const LatticePoint& p) const
    {
        SlitSkin::Soundness worst = SlitSkin::Soundness::sound;
        for (const std::uint32_t t : triangles_round(skin_, p))
            for (int i = 0; i < 3; ++i)
                worst = std::max(worst, skin_.soundness(skin_.triangle(t)[i]));
        if (worst == SlitSkin::Soundness::border) return "an open border of the surface";
        if (worst == SlitSkin::Soundness::tangled)
            return "faces that share an edge or a point in more than one way";
        return nullptr;
    }
    // Keeps the runs of sound points of a line, and names the first unsound thing that it touches.
    void keep_sound_parts(const Line& line, const char*& touched)
    {
        const DrawnChain& all = line.chain;
        for (std::size_t begin = 0, i = 0; i <= all.points.size(); ++i) {
            const char* const what = i < all.points.size() ? unsound(all.points[i]) : "";
            if (!what) continue;
            if (*what && !touched) touched = what;
            if (i > begin + 1) {
                const auto from = static_cast<std::ptrdiff_t>(begin),
                           to = static_cast<std::ptrdiff_t>(i - 1);
                Line part;
                part.chain.points.assign(all.points.begin() + from, all.points.begin() + to + 1);
                part.chain.triangles.assign(all.triangles.begin() + from,
                                            all.triangles.begin() + to);
                part.chain.from = share_at(line, begin);
                part.chain.to = share_at(line, i - 1);
                lines_.push_back(std::move(part));
            }
            begin = i + 1;
        }
    }
    // Between places in proportion to the way.
    double share_at(const Line& line, std::size_t i) const
    {
        std::size_t before = i, after = i;
        while (line.shares[before] < 0) --before;
        while (line.shares[after] < 0) ++after;
        double way = 0, whole = 0;
        for (std::size_t k = before; k < after; ++k) {
            whole += glm::distance(at(line.chain.points[k]), at(line.chain.points[k + 1]));
            if (k + 1 == i) way = whole;
        }
        return whole > 0 ? glm::mix(line.shares[before], line.shares[after], way / whole)
                         : line.shares[i];
    }

    const SlitDrawing& drawing_;
    const SlitSkin& skin_;
    DrawnChain chain_;
    std::vector<Line> lines_;
    bool leapt_ = false; // the surface did not go on to some place
};

} // namespace

Traced trace(const SlitDrawing& drawing, std::span<const StrokePart> parts)
{
    return Tracer(drawing)(parts);
}

} // namespace trivar
