// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_field.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/split/opening_bounds.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

constexpr double least_stretch = 0.02; // least dX/du
constexpr int checks = 41;             // along either axis, for the distance of cut surfaces

SplitRectangle common(const Opening& a, const Opening& b)
{
    return {glm::max(a.walls[0].lo(), b.walls[0].lo()), glm::min(a.walls[0].hi(), b.walls[0].hi())};
}

// The least of phi_b - phi_a where both openings are; infinite where they never are.
double least_distance(const Opening& a, const Opening& b)
{
    double least = std::numeric_limits<double>::infinity();
    const SplitRectangle where = common(a, b);
    if (!(where.lo.x < where.hi.x && where.lo.y < where.hi.y)) return least;
    for (int i = 0; i < checks; ++i)
        for (int j = 0; j < checks; ++j) {
            const glm::dvec2 at =
                glm::mix(where.lo, where.hi, glm::dvec2(i, j) / double{checks - 1});
            least = std::min(least, evaluate(b.surface, at).value - evaluate(a.surface, at).value);
        }
    return least;
}

double middle_of(const Opening& opening)
{
    return evaluate(opening.surface, (opening.walls[0].lo() + opening.walls[0].hi()) / 2.0).value;
}

Opening opening_of(const SplitObstacle& obstacle, const SplitFrame& frame)
{
    try {
        const ObstacleColumns columns(obstacle.bodies, frame);
        const SplitRectangle over = opening_rectangle(columns, obstacle.clearance, obstacle.margin);
        const CutSurface surface = middle_surface(columns, over);
        Opening out{surface,
                    opening_walls(columns, surface, over, obstacle.clearance, obstacle.ends),
                    {obstacle.reach, obstacle.reach},
                    obstacle.kernel,
                    obstacle.name,
                    obstacle.objects,
                    columns.box().lo.y - over.lo.x,
                    BicubicCells(surface),
                    {},
                    {}};
        for (std::size_t side = 0; side < 2; ++side)
            out.wall_cells[side] = BicubicCells(out.walls[side].height);
        out.bounds = make_ref(OpeningBounds(surface, out.walls[0].height, out.walls[1].height));
        return out;
    } catch (const Rejected& error) {
        throw Rejected(obstacle.name + " " + error.what());
    }
}

SplitObstacle joined(const SplitObstacle& a, const SplitObstacle& b)
{
    SplitObstacle out = a;
    out.name += " and " + b.name;
    out.bodies.insert(out.bodies.end(), b.bodies.begin(), b.bodies.end());
    out.objects.insert(out.objects.end(), b.objects.begin(), b.objects.end());
    out.clearance = std::max(a.clearance, b.clearance);
    out.reach = std::max(a.reach, b.reach);
    out.margin = std::max(a.margin, b.margin);
    out.ends = std::max(a.ends, b.ends);
    return out;
}

// Gives each side of each opening its reach: the one asked for, or the one that its kernel needs,
// in the room that it has beside the others.
void give_reaches(std::vector<Opening>& openings)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < openings.size(); ++i) {
        std::array<double, 2> room{endless, endless};
        for (std::size_t j = 0; j < openings.size(); ++j) {
            if (i == j) continue;
            const std::size_t side = j > i ? 1 : 0;
            const double distance = j > i ? least_distance(openings[i], openings[j])
                                          : least_distance(openings[j], openings[i]);
            const double own = openings[i].walls[side].most;
            const double others = openings[j].walls[1 - side].most;
            room[side] = std::min(room[side], distance * own / (own + others));
        }
        Opening& opening = openings[i];
        const auto fits = [&](SplitKernel kernel) {
            return needed_reach(opening, 0, kernel) <= room[0] &&
                   needed_reach(opening, 1, kernel) <= room[1];
        };
        if (!fits(opening.kernel)) opening.kernel = SplitKernel::hat;
        if (!fits(opening.kernel))
            throw Rejected(fmt::format(
                "{} is too near to another obstacle: {} m are free between them, but the parts "
                "need {} m; move it away or reduce its clearance",
                opening.name, number_text(std::min(room[0], room[1])),
                number_text(std::max(needed_reach(opening, 0, SplitKernel::hat),
                                     needed_reach(opening, 1, SplitKernel::hat)))));
        for (std::size_t side = 0; side < 2; ++side)
            opening.reach[side] = std::min(
                room[side],
                std::max({opening.reach[side], 1e-9, needed_reach(opening, side, opening.kernel)}));
    }
}

} // namespace

double needed_reach(const Opening& opening, std::size_t side, SplitKernel kernel)
{
    return steepest(kernel) * opening.walls[side].most / (1 - least_stretch);
}

SplitField split_field(const std::vector<SplitObstacle>& obstacles, const SplitFrame& frame)
{
    struct Each {
        SplitObstacle obstacle;
        Opening opening;
    };
    std::vector<Each> all;
    for (const SplitObstacle& obstacle : obstacles)
        all.push_back({obstacle, opening_of(obstacle, frame)});
    const auto sort = [&] {
        std::ranges::stable_sort(all, {}, [](const Each& e) { return middle_of(e.opening); });
    };
    sort();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            if (least_distance(all[i].opening, all[j].opening) <= 0) {
                const SplitObstacle both = joined(all[i].obstacle, all[j].obstacle);
                all[i] = {both, opening_of(both, frame)};
                all.erase(all.begin() + static_cast<long>(j));
                sort();
                i = static_cast<std::size_t>(-1); // once more from the beginning
                break;
            }
    SplitField out{.frame = frame, .openings = {}};
    for (Each& each : all) out.openings.push_back(std::move(each.opening));
    give_reaches(out.openings);
    return out;
}

SplitField::Moved SplitField::moved(const glm::dvec3& uvw, std::span<const char> sides,
                                    std::span<const char> on) const
{
    Moved out{uvw.x};
    const glm::dvec2 vw(uvw.y, uvw.z);
    for (std::size_t i = 0; i < openings.size(); ++i) {
        const Opening& o = openings[i];
        if (o.beyond_walls(vw)) continue;
        const std::size_t side = sides[i] ? 1 : 0;
        const BicubicCells::Jet phi = o.surface_cells.jet(vw);
        const double sign = side == 1 ? 1 : -1, reach = o.reach[side];
        // On its own side a point is at or beyond the surface, whatever rounding says
        const double distance = on[i] ? 0 : std::max(0.0, sign * (uvw.x - phi.value));
        if (distance >= reach) continue;
        const BicubicCells::Jet wall = o.wall_cells[side].jet(vw);
        const KernelValue k = kernel_at(o.kernel, distance / reach);
        const double slope = wall.value * k.first / reach; // sign * sign = 1
        out.u += sign * wall.value * k.value;
        out.gradient += glm::dvec3(slope, sign * wall.u * k.value - slope * phi.u,
                                   sign * wall.v * k.value - slope * phi.v);
    }
    return out;
}

Box SplitField::reach() const
{
    Box out;
    for (const Opening& o : openings) {
        const auto [least, most] = std::ranges::minmax(o.surface.points);
        const glm::dvec2 lo = o.walls[0].lo(), hi = o.walls[0].hi();
        out.add(glm::dvec3(least - o.reach[0], lo));
        out.add(glm::dvec3(most + o.reach[1], hi));
    }
    return out;
}

} // namespace trivar
