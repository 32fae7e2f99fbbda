// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_judge.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

// Sizes of pieces in quads of the index. Wider ones say nothing about points between their corners.
constexpr double widest = 2, widest_at_rim = 1, widest_outside = 0.5;
constexpr double finest = 1.0 / 11; // smaller pieces are not distinguished
// Numbers of cells by which the surface is continued beyond its rim to find where the rim cuts an
// edge, the share of the edge before the cut that is left out, and the number of corrections.
constexpr double beyond_rim = 1.5, rim_share = 0.01;
constexpr int rim_steps = 4;

using Corner = ScenePoint;

class Look {
public:
    Look(const SurfaceTable& surface, const View& view, const StripIndex& strip,
         const JudgeOptions& options)
        : surface_(surface),
          view_(view),
          strip_(strip),
          options_(options)
    {
    }

    Corner corner(const glm::dvec3& p_world, const PicturePoint& at, Judgement& out) const
    {
        Corner c{p_world, at.p_px, at.depth_world};
        strip_.find(at.p_px, [&](const glm::dvec2& uv) {
            const Gap g = gap_at(surface_, view_, {p_world, uv});
            if (g.inside) cover(c, g, out);
        });
        return c;
    }

    void triangle(const Corner& a, const Corner& b, const Corner& c, int halvings,
                  Judgement& out) const
    {
        const int covered = a.covered + b.covered + c.covered;
        if (covered == 0 && !strip_.may_touch(glm::min(glm::min(a.p_px, b.p_px), c.p_px),
                                              glm::max(glm::max(a.p_px, b.p_px), c.p_px)))
            return;
        const double ab = squared(a, b), bc = squared(b, c), ca = squared(c, a);
        const double longest = std::max({ab, bc, ca});
        const double wide = covered == 3 ? widest : covered > 0 ? widest_at_rim : widest_outside;
        const double limit = wide * strip_.quad_px() * wide * strip_.quad_px();
        if (longest <= limit) {
            if (covered == 0) return;
            double least = std::min({a.gap, b.gap, c.gap});
            if (covered < 3 && halvings == 0)
                least = std::min({least, rim(a, b, out), rim(b, c, out), rim(c, a, out)});
            const bool fine = least - sag(a, b, c, longest) >= -options_.let_be;
            const double smallest = finest * strip_.quad_px();
            if (fine || least < -options_.hopeless || longest < smallest * smallest) return;
            ++halvings;
        }
        if (ab == longest)
            halve(a, b, c, halvings, out);
        else if (bc == longest)
            halve(b, c, a, halvings, out);
        else
            halve(c, a, b, halvings, out);
    }

private:
    // Bounds how far the surface may sag behind the triangle between its corners. The length on the
    // surface comes from the parameters of the corners or, if one is outside the strip, from the
    // picture.
    double sag(const Corner& a, const Corner& b, const Corner& c, double longest) const
    {
        // This is twice the sag of a parabola, because the surface is not one.
        constexpr double share = 2 / 8.0;
        glm::dvec2 lo(1), hi(0);
        for (const Corner* corner : {&a, &b, &c}) {
            if (!corner->covered) continue;
            lo = glm::min(lo, corner->uv);
            hi = glm::max(hi, corner->uv);
        }
        const StripIndex::Bend bend = strip_.bend(lo, hi);
        if (a.covered && b.covered && c.covered) {
            const glm::dvec2 quads(strip_.steps());
            return share * std::max({0.0, bend.across((b.uv - a.uv) * quads),
                                     bend.across((c.uv - b.uv) * quads),
                                     bend.across((a.uv - c.uv) * quads)});
        }
        const glm::dvec2 size = glm::sqrt(longest / bend.quad_px2);
        return share * std::max({0.0, bend.across(size), bend.across({size.x, -size.y}),
                                 bend.along.x * size.x * size.x, bend.along.y * size.y * size.y});
    }

    void cover(Corner& c, const Gap& by, Judgement& out) const
    {
        const double gap = by.gap - options_.clearance;
        c.covered = true;
        if (gap < c.gap) {
            c.gap = gap;
            c.uv = by.uv;
        }
        if (gap < -options_.let_be) out.behind.push_back({c.p_world, by.uv});
        out.worst = std::max(out.worst, -gap);
    }

    static double squared(const Corner& a, const Corner& b)
    {
        const glm::dvec2 d = b.p_px - a.p_px;
        return glm::dot(d, d);
    }

    void halve(const Corner& a, const Corner& b, const Corner& apex, int halvings,
               Judgement& out) const
    {
        const Corner middle = corner_between(a, b, 0.5, out);
        triangle(a, middle, apex, halvings, out);
        triangle(middle, b, apex, halvings, out);
    }

    // Returns the corner at a share of the edge in the picture; equal steps there are not equal in
    // space.
    Corner corner_between(const Corner& a, const Corner& b, double t, Judgement& out) const
    {
        const double za = a.depth_world, zb = b.depth_world;
        const double s = view_.perspective() ? t * za / (t * za + (1 - t) * zb) : t;
        return corner(glm::mix(a.p_world, b.p_world, s),
                      {glm::mix(a.p_px, b.p_px, t), za + s * (zb - za)}, out);
    }

    // Returns the gap where the rim of the strip cuts the edge, if it does. The parameters at both
    // ends tell where, because the surface continues a little beyond its rim.
    double rim(const Corner& a, const Corner& b, Judgement& out) const
    {
        if (a.covered == b.covered) return 1e300;
        const Corner &inside = a.covered ? a : b, &outside = a.covered ? b : a;
        Corner tried = outside;
        double share = 1; // of the edge, from the inside
        for (int step = 0; step < rim_steps; ++step) {
            const Gap g = gap_at(surface_, view_, {tried.p_world, inside.uv}, beyond_rim);
            double cut = g.inside ? 1 : 0.5;
            for (int k = 0; k < 2 && g.inside; ++k) {
                const double from = inside.uv[k], to = g.uv[k];
                if (to > 1) cut = std::min(cut, (1 - from) / (to - from));
                if (to < 0) cut = std::min(cut, from / (from - to));
            }
            if (cut == 1) {
                // The strip continues here, beside the examined part.
                cover(tried, g, out);
                return tried.gap;
            }
            share *= std::max(0.0, cut - rim_share);
            tried = corner_between(inside, outside, share, out);
            if (tried.covered) return tried.gap;
        }
        return inside.gap;
    }

    const SurfaceTable& surface_;
    const View& view_;
    const StripIndex& strip_;
    const JudgeOptions& options_;
};

// Combines the judgements of the blocks in order, so that they are the same for any number of
// threads.
template <class Body>
void in_blocks(std::size_t count, std::size_t block, Judgement& to, const Body& body)
{
    std::vector<Judgement> parts((count + block - 1) / block);
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) body(i, parts[begin / block]);
    });
    for (const Judgement& part : parts) to.add(part);
}

} // namespace

StripJudge::StripJudge(const SurfaceTable& surface, const View& view, const NearScene& scene,
                       const JudgeOptions& options)
    : surface_(surface),
      view_(view),
      scene_(scene),
      options_(options),
      corners_(scene.vertices.size())
{
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const NearScene::Vertex& v = scene.vertices[i];
        corners_[i] = {v.p_world, v.at.p_px, v.at.depth_world};
    }
}

Judgement StripJudge::judge(const StripIndex& strip)
{
    const Look look(surface_, view_, strip, options_);
    Judgement out;
    // Places that the strip has just left count as changed, too.
    const glm::dvec2 around(strip.quad_px());
    in_blocks(corners_.size(), 512, out, [&](std::size_t i, Judgement& to) {
        ScenePoint& c = corners_[i];
        if (strip.changed(c.p_px - around, c.p_px + around))
            c = look.corner(c.p_world, {c.p_px, c.depth_world}, to);
    });
    in_blocks(scene_.triangles.size(), 512, out, [&](std::size_t i, Judgement& to) {
        const auto [a, b, c] = scene_.triangles[i];
        const ScenePoint &p = corners_[a], &q = corners_[b], &r = corners_[c];
        if (strip.changed(glm::min(glm::min(p.p_px, q.p_px), r.p_px),
                          glm::max(glm::max(p.p_px, q.p_px), r.p_px)))
            look.triangle(p, q, r, 0, to);
    });
    return out;
}

} // namespace trivar
