// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/fill.h"

#include "core/base/mistake.h"
#include "core/plane/triangulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

constexpr int most_passes = 12; // of turning edges over
using Corners = Triangulation::Corners;

// Pieces of one triangle that may turn their common edges over.
class Pieces {
public:
    Pieces(const std::vector<glm::ivec2>& at, const std::vector<Corners>& pieces,
           const glm::dvec3& e1, const glm::dvec3& e2)
        : at_(at),
          pieces_(pieces)
    {
        const glm::dvec3 x = glm::normalize(e1);
        const glm::dvec3 y = glm::cross(glm::normalize(glm::cross(e1, e2)), x);
        for (const glm::ivec2& p : at_) {
            const glm::dvec3 q =
                double(p.x) / lattice_steps * e1 + double(p.y) / lattice_steps * e2;
            true_.emplace_back(glm::dot(q, x), glm::dot(q, y));
        }
    }
    void keep(int a, int b) { kept_.push_back(std::minmax(a, b)); }

    // In the true metric; only in strictly convex quads, so that orientation stays exact.
    const std::vector<Corners>& turned_over()
    {
        std::ranges::sort(kept_);
        for (int pass = 0; pass < most_passes; ++pass) {
            bool any = false;
            for (std::size_t f = 0; f < pieces_.size(); ++f)
                for (std::size_t i = 0; i < 3; ++i) any = turn_over(f, i) || any;
            if (!any) break;
        }
        return pieces_;
    }

private:
    double angle(int a, int b, int c) const
    {
        const glm::dvec2 u = true_[at_index(b)] - true_[at_index(a)];
        const glm::dvec2 v = true_[at_index(c)] - true_[at_index(a)];
        return std::atan2(std::abs(u.x * v.y - u.y * v.x), glm::dot(u, v));
    }
    static std::size_t at_index(int i) { return static_cast<std::size_t>(i); }
    std::int64_t turn_at(int a, int b, int c) const
    {
        return turn(at_[at_index(a)], at_[at_index(b)], at_[at_index(c)]);
    }
    // The edge from corner i + 1 to i + 2, if it need not stay.
    bool turn_over(std::size_t f, std::size_t i)
    {
        const int a = pieces_[f][i], b = pieces_[f][(i + 1) % 3], c = pieces_[f][(i + 2) % 3];
        if (b > c || std::ranges::binary_search(kept_, std::pair<int, int>(std::minmax(b, c))))
            return false;
        for (std::size_t g = 0; g < pieces_.size(); ++g)
            for (std::size_t k = 0; k < 3; ++k) {
                if (pieces_[g][(k + 1) % 3] != c || pieces_[g][(k + 2) % 3] != b) continue;
                const int d = pieces_[g][k];
                if (turn_at(a, b, d) <= 0 || turn_at(a, d, c) <= 0) return false;
                if (angle(a, b, c) + angle(d, c, b) <= std::numbers::pi + 1e-9) return false;
                pieces_[f] = {a, b, d};
                pieces_[g] = {a, d, c};
                return true;
            }
        return false; // on the rim of the triangle
    }

    std::vector<glm::ivec2> at_;
    std::vector<Corners> pieces_;
    std::vector<glm::dvec2> true_;
    std::vector<std::pair<int, int>> kept_;
};

} // namespace

std::vector<SkinTriangle> filled(const SlitDrawing& drawing, std::uint32_t triangle)
{
    const SlitSkin& skin = drawing.skin();
    Triangulation plane;
    std::vector<std::uint32_t> numbers; // of the drawing, by point of the plane
    KeyNumbers known;
    const auto add = [&](std::uint32_t number) {
        const std::optional<glm::ivec2> at = weights_in(skin, drawing.point(number), triangle);
        ensure(at.has_value(), "a point of an incision lies outside its triangle");
        const int i = plane.insert(*at);
        ensure(static_cast<std::size_t>(i) == numbers.size(), "two points of an incision are one");
        known.insert(number, static_cast<std::uint32_t>(i));
        numbers.push_back(number);
        return i;
    };
    const glm::uvec3& corners = skin.triangle(triangle);
    for (int i = 0; i < 3; ++i) add(corners[i]);
    std::vector<std::pair<int, int>> rim;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t side = 3 * triangle + i;
        int last = static_cast<int>(i);
        if (const auto* on = drawing.on_edge(skin.edge(side))) {
            std::vector<SlitDrawing::OnEdge> row = *on;
            std::ranges::sort(row);
            if (skin.from(side) > skin.to(side)) std::ranges::reverse(row);
            for (const SlitDrawing::OnEdge& each : row) {
                const int next = add(each.point);
                rim.emplace_back(last, next);
                last = next;
            }
        }
        rim.emplace_back(last, static_cast<int>((i + 1) % 3));
    }
    std::vector<std::pair<int, int>> lines;
    if (const SlitDrawing::OnTriangle* on = drawing.on_triangle(triangle)) {
        for (const std::uint32_t p : on->points) add(p);
        for (const std::uint32_t s : on->segments) {
            const SlitDrawing::Segment& g = drawing.segments()[s];
            if (g.a != g.b)
                lines.emplace_back(static_cast<int>(known.find(g.a)),
                                   static_cast<int>(known.find(g.b)));
        }
    }
    for (const auto* edges : {&rim, &lines})
        for (const auto& [a, b] : *edges) {
            const Triangulation::JoinResult joined = plane.join(a, b);
            ensure(joined == Triangulation::JoinResult::one_edge, "lines of an incision cross");
        }
    const bool enclosed = plane.fill(rim);
    ensure(enclosed, "the sides of a triangle do not enclose it");

    const glm::dvec3 origin = skin.position(corners.x);
    Pieces pieces(plane.points(), plane.inside(), skin.position(corners.y) - origin,
                  skin.position(corners.z) - origin);
    for (const auto& [a, b] : lines) pieces.keep(a, b);
    std::vector<SkinTriangle> out;
    for (const Corners& c : pieces.turned_over())
        out.push_back(
            {{numbers[static_cast<std::size_t>(c[0])], numbers[static_cast<std::size_t>(c[1])],
              numbers[static_cast<std::size_t>(c[2])]},
             triangle});
    return out;
}

} // namespace trivar
