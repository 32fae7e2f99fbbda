// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/thinned_chain.h"

#include "core/base/share_along.h"
#include "core/base/unit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {
namespace {

using On = LatticePoint::On;

constexpr double least_bend = 0.1; // of the shortest side: a point nearer to its chord is not drawn
constexpr double hook = -0.2;      // cosine of the turn at an end that is a slip of the hand

class Thinning {
public:
    Thinning(const SlitSkin& skin, DrawnChain chain) : skin_(skin), chain_(std::move(chain)) {}

    DrawnChain operator()() &&
    {
        if (!(chain_.points.front() == chain_.points.back())) drop_hooks();
        drop_points_on_chords();
        if (chain_.points.size() == 2) halve();
        return std::move(chain_);
    }

private:
    glm::dvec3 at(const LatticePoint& p) const { return position(skin_, p); }
    double side_length(std::uint32_t side) const
    {
        return glm::distance(skin_.position(skin_.from(side)), skin_.position(skin_.to(side)));
    }

    // Returns the cosine of the turn at a point, with the triangles on both sides of an edge
    // unfolded.
    double cosine_at(std::size_t i) const
    {
        const std::vector<LatticePoint>& points = chain_.points;
        const std::vector<std::uint32_t>& triangles = chain_.triangles;
        const glm::dvec3 in = unit_or_zero(at(points[i]) - at(points[i - 1]));
        const glm::dvec3 out = unit_or_zero(at(points[i + 1]) - at(points[i]));
        if (points[i].on != On::edge || triangles[i - 1] == triangles[i]) return glm::dot(in, out);
        const std::uint32_t side = points[i].index;
        const glm::dvec3 edge =
            glm::normalize(skin_.position(skin_.to(side)) - skin_.position(skin_.from(side)));
        const double u = glm::dot(in, edge), v = glm::dot(out, edge);
        return u * v + std::sqrt(std::max(0.0, (1 - u * u) * (1 - v * v)));
    }
    void drop_hooks()
    {
        std::vector<LatticePoint>& points = chain_.points;
        std::vector<std::uint32_t>& triangles = chain_.triangles;
        while (points.size() > 3 && cosine_at(1) < hook) {
            points.erase(points.begin());
            triangles.erase(triangles.begin());
        }
        while (points.size() > 3 && cosine_at(points.size() - 2) < hook) {
            points.pop_back();
            triangles.pop_back();
        }
    }
    void drop_points_on_chords()
    {
        std::vector<LatticePoint>& points = chain_.points;
        std::vector<std::uint32_t>& triangles = chain_.triangles;
        std::vector<char> kept(points.size(), 0);
        kept[0] = 1;
        for (std::size_t begin = 0; begin + 1 < points.size();) {
            const std::uint32_t t = triangles[begin]; // that a run of points belongs to
            std::size_t end = begin + 1;
            while (end + 1 < points.size() && points[end].on != On::point &&
                   weights_in(skin_, points[end + 1], t))
                triangles[end++] = t;
            kept[end] = 1;
            keep_bends(begin, end, kept);
            begin = end;
        }
        DrawnChain rest;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!kept[i]) continue;
            rest.points.push_back(points[i]);
            if (i + 1 < points.size()) rest.triangles.push_back(triangles[i]);
        }
        chain_.points = std::move(rest.points);
        chain_.triangles = std::move(rest.triangles);
    }
    // Keeps the points between two kept ones, inside one triangle, at which the line bends.
    void keep_bends(std::size_t first, std::size_t last, std::vector<char>& kept) const
    {
        const std::uint32_t side = 3 * chain_.triangles[first];
        const double near = least_bend * std::min({side_length(side), side_length(side + 1),
                                                   side_length(side + 2)});
        std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
        while (!open.empty()) {
            const auto [from, to] = open.back();
            open.pop_back();
            const glm::dvec3 a = at(chain_.points[from]), d = at(chain_.points[to]) - a;
            double most = near;
            std::size_t bend = from;
            for (std::size_t i = from + 1; i < to; ++i) {
                const glm::dvec3 x = at(chain_.points[i]);
                const double away = glm::distance(x, a + share_along(x, a, d) * d);
                if (away < most) continue;
                most = away;
                bend = i;
            }
            // A line that comes back to where it began has to go somewhere
            if (bend == from && chain_.points[from] == chain_.points[to] && to > from + 1)
                bend = (from + to) / 2;
            if (bend == from) continue;
            kept[bend] = 1;
            open.emplace_back(from, bend);
            open.emplace_back(bend, to);
        }
    }
    // A single segment gets a point in its middle, which can open.
    void halve()
    {
        std::vector<LatticePoint>& points = chain_.points;
        std::vector<std::uint32_t>& triangles = chain_.triangles;
        const std::uint32_t t = triangles[0];
        const auto a = weights_in(skin_, points[0], t), b = weights_in(skin_, points[1], t);
        const LatticePoint middle = lattice_point(skin_, t, (*a + *b) / 2);
        if (middle == points[0] || middle == points[1]) return;
        points.insert(points.begin() + 1, middle);
        triangles.push_back(t);
    }

    const SlitSkin& skin_;
    DrawnChain chain_;
};

} // namespace

DrawnChain thinned(const SlitSkin& skin, DrawnChain chain)
{
    return Thinning(skin, std::move(chain))();
}

} // namespace trivar
