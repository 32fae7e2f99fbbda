// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/wall_certificate.h"

#include "core/base/parallel.h"
#include "core/split/bicubic_cells.h"
#include "core/split/surface_bounds.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>

namespace trivar {
namespace {

constexpr std::size_t triangles_per_turn = 16;
constexpr double all_halvings = 1 << 19; // about, of all triangles
constexpr std::size_t fewest_halvings = 32;
constexpr double share_of_wall_bend = 1.0 / 6; // as in SplitError

struct Corner {
    glm::dvec3 uvw;
    double gap; // between the wall and this point
};

using Triangle = std::array<Corner, 3>;

class Judge {
public:
    Judge(const CutSurface& surface, const Surface<double>& wall, std::size_t side, double wanted)
        : surface_(surface),
          wall_(wall),
          surface_bounds_(surface, false),
          wall_bounds_(wall, true),
          lo_(wall.axes[0].begin(), wall.axes[1].begin()),
          hi_(wall.axes[0].end(), wall.axes[1].end()),
          sign_(side == 0 ? -1 : 1),
          wanted_(wanted)
    {
    }
    Corner corner(const glm::dvec3& uvw) const
    {
        const glm::dvec2 vw(uvw.y, uvw.z);
        const bool beyond = !(vw.x > lo_.x && vw.x < hi_.x && vw.y > lo_.y && vw.y < hi_.y);
        return {uvw, (beyond ? 0 : wall_.value(vw)) - sign_ * (uvw.x - surface_.value(vw))};
    }
    Triangle triangle(const ObstacleColumns& obstacle, std::size_t t) const
    {
        const std::vector<glm::dvec3>& p = obstacle.vertices();
        const glm::uvec3& v = obstacle.triangles()[t];
        return {corner(p[v.x]), corner(p[v.y]), corner(p[v.z])};
    }
    // Estimates how many halvings make it certain: each halves the bend.
    double work(const Triangle& t) const
    {
        const double least = std::min({t[0].gap, t[1].gap, t[2].gap}), bend = bend_of(t).most;
        return least - bend >= wanted_ ? 0 : bend / wanted_;
    }
    void judge(const Triangle& whole, std::size_t most_halvings, WallCertificate& out) const
    {
        std::priority_queue<Piece> open; // what is least certain is halved first
        open.push(piece(whole));
        for (std::size_t halvings = 0; !open.empty();) {
            const Piece p = open.top();
            if (p.certain >= wanted_) return;
            open.pop();
            const auto& [t, certain, bend] = p;
            const double least = certain + bend.most;
            if (least < wanted_ || halvings >= most_halvings) {
                out.clear = std::min(out.clear, certain);
                for (const Corner& c : t)
                    if (c.gap < wanted_) out.too_near.push_back(c.uvw);
                // A corner that is too near makes no smaller piece good
                if (halvings >= most_halvings || bend.most < 0.25 * wanted_) continue;
            }
            ++halvings;
            const std::size_t edge = bend.edge;
            const Corner &a = t[edge], &b = t[(edge + 1) % 3], &c = t[(edge + 2) % 3];
            const Corner middle = corner((a.uvw + b.uvw) / 2.0);
            open.push(piece({a, middle, c}));
            open.push(piece({middle, b, c}));
        }
    }

private:
    struct Bend {
        double most;
        std::size_t edge; // the one that bends most
    };
    struct Piece {
        Triangle triangle;
        double certain; // distance from the wall
        Bend bend;
        bool operator<(const Piece& other) const { return certain > other.certain; }
    };
    Piece piece(const Triangle& t) const
    {
        const Bend bend = bend_of(t);
        return {t, std::min({t[0].gap, t[1].gap, t[2].gap}) - bend.most, bend};
    }
    Bend bend_of(const Triangle& t) const
    {
        const auto vw = [&](std::size_t i) { return glm::dvec2(t[i % 3].uvw.y, t[i % 3].uvw.z); };
        const glm::dvec2 lo = glm::min(glm::min(vw(0), vw(1)), vw(2));
        const glm::dvec2 hi = glm::max(glm::max(vw(0), vw(1)), vw(2));
        const JetBound phi = surface_bounds_.over(lo, hi), w = wall_bounds_.over(lo, hi);
        Bend out{-1, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 e = vw(i + 1) - vw(i);
            const double bend = share_of_wall_bend * (phi.second(e) + w.second(e));
            if (bend > out.most) out = {bend, i};
        }
        return out;
    }

    BicubicCells surface_, wall_;
    SurfaceBounds surface_bounds_, wall_bounds_;
    glm::dvec2 lo_, hi_; // of the wall's rectangle
    double sign_, wanted_;
};

} // namespace

WallCertificate certificate(const ObstacleColumns& obstacle, const CutSurface& surface,
                            const Surface<double>& wall, std::size_t side, double wanted)
{
    const std::size_t triangles = obstacle.triangles().size();
    const Judge judge(surface, wall, side, wanted);
    // Each triangle has its share of the halvings: two of a box may need more than a whole star
    std::vector<double> work(triangles);
    parallel_blocks(triangles, triangles_per_turn, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) work[t] = judge.work(judge.triangle(obstacle, t));
    });
    const double all = std::max(1.0, std::accumulate(work.begin(), work.end(), 0.0));
    std::vector<WallCertificate> blocks(triangles / triangles_per_turn + 1, {wanted, {}});
    parallel_blocks(triangles, triangles_per_turn, [&](std::size_t begin, std::size_t end) {
        WallCertificate block{wanted, {}};
        for (std::size_t t = begin; t < end; ++t)
            judge.judge(judge.triangle(obstacle, t),
                        fewest_halvings + static_cast<std::size_t>(all_halvings * work[t] / all),
                        block);
        blocks[begin / triangles_per_turn] = std::move(block);
    });
    WallCertificate out{wanted, {}};
    for (const WallCertificate& each : blocks) {
        out.clear = std::min(out.clear, each.clear);
        out.too_near.insert(out.too_near.end(), each.too_near.begin(), each.too_near.end());
    }
    return out;
}

} // namespace trivar
