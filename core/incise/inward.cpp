// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/inward.h"

#include "core/base/unit.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

constexpr int smoothing_rounds = 5;
constexpr int most_turns = 60;
constexpr double turn_share = 0.3;   // of the normal of the face that sees it worst
constexpr double well_seen = 0.2;    // cosine
constexpr double hardly_seen = 0.02; // cosine; less: not at all
constexpr double least_radius = 2.5; // edges: nearer sources tell nothing that rings do not
constexpr double same_side = 0.2;    // cosine with what is told for the other side of a thin body
constexpr double least_layer = 0.15; // of the area at the skin
constexpr double shallower = 0.8;    // the next depth to try
constexpr int most_depths = 24;

} // namespace

Inward::Inward(const SlitSkin& skin, std::span<const std::uint32_t> triangles) : skin_(&skin)
{
    std::vector<std::uint32_t>& points = points_;
    const auto put = [&](std::uint32_t p) {
        if (number_.number(p).second) points.push_back(p);
    };
    for (const std::uint32_t t : triangles)
        for (int i = 0; i < 3; ++i) put(skin.triangle(t)[i]);
    const std::size_t asked = points.size();
    std::size_t ring = 0;
    for (int round = 0; round < smoothing_rounds; ++round) {
        const std::size_t end = points.size();
        for (; ring < end; ++ring)
            skin.around(points[ring], [&](std::uint32_t side) {
                put(skin.to(side));
                put(skin.from(SlitSkin::previous(side)));
            });
    }
    std::vector<glm::dvec3> now, next(points.size());
    for (const std::uint32_t p : points) now.push_back(skin.normal(p));
    std::vector<std::uint32_t> around; // numbers of all corners of the faces round each point
    std::vector<std::size_t> end_of;   // by point
    for (const std::uint32_t p : points) {
        skin.around(p, [&](std::uint32_t side) {
            for (int k = 0; k < 3; ++k)
                if (const std::uint32_t n = number_.find(skin.triangle(side / 3)[k]);
                    n != KeyNumbers::none)
                    around.push_back(n);
        });
        end_of.push_back(around.size());
    }
    for (int round = 0; round < smoothing_rounds; ++round) {
        for (std::size_t i = 0, k = 0; i < points.size(); ++i) {
            glm::dvec3 sum(0);
            for (; k < end_of[i]; ++k) sum += now[around[k]];
            next[i] = unit_or_zero(sum);
        }
        now.swap(next);
    }
    directions_.resize(asked);
    for (std::size_t i = 0; i < asked; ++i) {
        directions_[i].outward = now[i];
        turn_to_faces(points[i], directions_[i]);
    }
}

void Inward::follow(std::vector<Source> sources)
{
    std::erase_if(sources, [&](const Source& each) {
        return each.radius < least_radius * skin_->usual_edge();
    });
    if (sources.empty()) return;
    std::ranges::stable_sort(sources, {}, [](const Source& each) { return each.p.x; });
    double widest = 0;
    for (const Source& each : sources) widest = std::max(widest, each.radius);
    for (std::size_t i = 0; i < directions_.size(); ++i) {
        const glm::dvec3& x = skin_->position(points_[i]);
        glm::dvec3 sum(0);
        auto source = std::ranges::lower_bound(sources, x.x - widest, {},
                                               [](const Source& each) { return each.p.x; });
        for (; source != sources.end() && source->p.x < x.x + widest; ++source) {
            const double away = glm::distance(source->p, x) / source->radius;
            if (!(away < 1) || glm::dot(source->outward, directions_[i].outward) < same_side)
                continue;
            sum += source->length * (1 - away * away) * (1 - away * away) * source->outward;
        }
        if (sum == glm::dvec3(0)) continue;
        directions_[i].outward = unit_or_zero(sum);
        turn_to_faces(points_[i], directions_[i]);
    }
}

void Inward::turn_to_faces(std::uint32_t point, Direction& d) const
{
    double worst = 0;
    for (int turn = 0; turn < most_turns; ++turn) {
        worst = 2;
        glm::dvec3 worst_normal(0);
        skin_->around(point, [&](std::uint32_t side) {
            const glm::dvec3 n = unit_or_zero(skin_->area_normal(side / 3));
            const double cosine = glm::dot(n, d.outward);
            if (cosine >= worst) return;
            worst = cosine;
            worst_normal = n;
        });
        if (worst > well_seen) break;
        d.outward = unit_or_zero(d.outward + turn_share * worst_normal);
    }
    d.seen = worst > hardly_seen;
}

glm::dvec3 Inward::outward(std::uint32_t point) const
{
    const std::uint32_t n = number_.find(point);
    return n < directions_.size() ? directions_[n].outward : skin_->normal(point);
}

glm::dvec3 Inward::outward(const LatticePoint& p) const
{
    return blend_of(*skin_, p)([&](std::uint32_t point) { return outward(point); });
}

bool Inward::has_inside(const LatticePoint& p) const
{
    const Blend blend = blend_of(*skin_, p);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t n = number_.find(blend.of[i]);
        if (n < directions_.size() && !directions_[n].seen) return false;
    }
    return true;
}

namespace {

// The area of the layer at depth w over each corner's direction n_k: det[e1 - w m1, e2 - w m2,
// n_k].
class LayerAreas {
public:
    LayerAreas(const SlitSkin& skin, const Inward& inward, std::uint32_t triangle)
    {
        const glm::uvec3& t = skin.triangle(triangle);
        n_ = {inward.outward(t.x), inward.outward(t.y), inward.outward(t.z)};
        e1_ = skin.position(t.y) - skin.position(t.x);
        e2_ = skin.position(t.z) - skin.position(t.x);
    }
    double area(double w, std::size_t k) const
    {
        return glm::dot(glm::cross(e1_ - w * (n_[1] - n_[0]), e2_ - w * (n_[2] - n_[0])), n_[k]);
    }

private:
    std::array<glm::dvec3, 3> n_;
    glm::dvec3 e1_, e2_;
};

} // namespace

// A layer is turned right if its areas are positive at all three corners: quadratics in w, bounded
// by their Bernstein coefficients.
double Inward::depth_below(std::uint32_t triangle, double wanted) const
{
    const LayerAreas layer(*skin_, *this, triangle);
    for (int i = 0; i < most_depths; ++i, wanted *= shallower) {
        bool fits = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const double c0 = layer.area(0, k), c2 = layer.area(wanted, k);
            const double c1 = 2 * layer.area(wanted / 2, k) - (c0 + c2) / 2;
            fits = fits && c0 > 0 && c1 > least_layer * c0 && c2 > least_layer * c0;
        }
        if (fits) return wanted;
    }
    return 0;
}

} // namespace trivar
