// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand.h"

#include "core/tiles/on_surface.h"
#include "core/tiles/random_share.h"
#include "core/tiles/tile_brushes.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double points_per_cell = 12;
// Lengths in sizes of a tile: the part of its path over which a strand is smoothed, the distance
// within which an end snaps to another one, the least length of a strand, and the way that a strand
// goes straight on from its joint.
constexpr double path_smoothing = 0.3, snap_reach = 0.75, least_strand = 0.3, straight_on = 0.4;
// Strands are as thin as this where nobody presses the pen, and not of no width at all.
constexpr double thinnest = 0.02;
// A closed strand has at least as many cells, and an even number: every other one may be turned.
constexpr double least_round = 4;

class StrandBuilder {
public:
    StrandBuilder(StrandLayout& layout, const TileBase& base, const TileStroke& stroke, int number)
        : layout_(layout),
          base_(base),
          stroke_(stroke),
          number_(number)
    {
    }

    void lay(std::vector<StrandPoint> points)
    {
        if (points.empty()) return;
        bool closed = false;
        if (!stroke_.apart && points.size() > 1) {
            choose_sockets(points);
            double around = 0;
            for (std::size_t i = 1; i < points.size(); ++i)
                around += glm::distance(points[i].at.p, points[i - 1].at.p);
            closed = from_ < 0 && to_ < 0 && near(points.front().at.p, points.back().at.p) &&
                     around > 3 * stroke_.size;
        }
        lead_from_sockets(points);
        const StrandPath path = strand_path(base_, points, closed, stroke_.size / points_per_cell,
                                            path_smoothing * stroke_.size);
        if (!(path.length() > least_strand * stroke_.size)) {
            double chain = 0; // nothing is left of it where it would have too many points
            for (std::size_t i = 1; i < points.size(); ++i)
                chain += glm::distance(points[i].at.p, points[i - 1].at.p);
            if (chain > most_tiles * stroke_.size / points_per_cell)
                layout_.too_many = true;
            else
                ++layout_.too_short;
            return;
        }
        divide(path);
    }

private:
    bool near(const glm::dvec3& a, const glm::dvec3& b) const
    {
        return glm::distance(a, b) <= snap_reach * stroke_.size;
    }
    const StrandStation& end_of(int cell, bool last) const
    {
        return layout_
            .stations[layout_.cells[static_cast<std::size_t>(cell)].stations[last ? 3 : 0]];
    }
    glm::dvec3 position_of_end(int cell, bool last) const
    {
        return base_.position(end_of(cell, last).at);
    }

    // The cell of another stroke whose open end is nearest to a point; -1: none is near.
    int open_end(const glm::dvec3& p, bool last) const
    {
        int best = -1;
        double least = snap_reach * stroke_.size;
        for (std::size_t i = 0; i < layout_.cells.size(); ++i) {
            const StrandCell& cell = layout_.cells[i];
            if (cell.gone || (last ? cell.behind : cell.before) >= 0) continue;
            const double away = glm::distance(p, position_of_end(static_cast<int>(i), last));
            if (away <= least) least = away, best = static_cast<int>(i);
        }
        return best;
    }

    // Chooses the ends from which the path goes on and to which it leads. It is turned round if
    // that links more.
    void choose_sockets(std::vector<StrandPoint>& points)
    {
        const glm::dvec3 first = points.front().at.p, last = points.back().at.p;
        from_ = open_end(first, true);
        to_ = open_end(last, false);
        const int turned_from = open_end(last, true), turned_to = open_end(first, false);
        if ((turned_from >= 0) + (turned_to >= 0) > (from_ >= 0) + (to_ >= 0)) {
            std::ranges::reverse(points);
            from_ = turned_from;
            to_ = turned_to;
        }
    }

    // Lets the path leave a station, or come to it, in the direction that it has there.
    void lead_from_socket(std::vector<StrandPoint>& points, const StrandStation& socket,
                          double ahead) const
    {
        const SurfacePoint there{base_.position(socket.at), base_.normal(socket.at)};
        StrandPoint end = points.front(), on = end;
        const auto away = [&](const StrandPoint& each) {
            return glm::distance(each.at.p, there.p) >= 2 * straight_on * stroke_.size;
        };
        points.erase(points.begin(), std::find_if(points.begin(), points.end() - 1, away));
        end.at = there;
        on.at = {there.p + ahead * straight_on * stroke_.size * socket.x, there.normal};
        points.insert(points.begin(), {end, on});
    }
    void lead_from_sockets(std::vector<StrandPoint>& points) const
    {
        if (from_ >= 0) lead_from_socket(points, end_of(from_, true), 1);
        if (to_ < 0) return;
        std::ranges::reverse(points);
        lead_from_socket(points, end_of(to_, false), -1);
        std::ranges::reverse(points);
    }

    double cell_count(const StrandPath& path) const
    {
        const double wanted = path.length() / stroke_.size;
        return path.closed ? std::max(least_round, 2 * std::round(wanted / 2))
                           : std::max(1.0, std::round(wanted));
    }

    // Adds the stations at equal steps and the cells between them.
    void divide(const StrandPath& path)
    {
        const double count = cell_count(path), length = path.length() / count;
        if (!(count + static_cast<double>(layout_.cells.size()) <= most_tiles)) {
            layout_.too_many = true;
            return;
        }
        constexpr std::array<double, 3> stations{0, 0.25, 0.75}; // of each cell
        std::vector<StrandPoint> points;
        std::vector<double> lengths;
        for (double k = 0; k < count; ++k)
            for (const double share : stations) lengths.push_back((k + share) * length);
        lengths.push_back(path.length());
        std::vector<SurfacePoint> above;
        for (const double each : lengths) {
            points.push_back(path.at(each));
            above.push_back({points.back().at.p, glm::normalize(points.back().at.normal)});
        }
        points.back().time_s = path.points.back().time_s;
        const auto places = base_.locate(above, stroke_.size);
        const auto first = static_cast<std::uint32_t>(layout_.stations.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            add_station(path, places[i], lengths[i], length, points[i]);
        const auto cells = static_cast<int>(layout_.cells.size()), n = static_cast<int>(count);
        const int numbers = from_ >= 0 ? layout_.cells[static_cast<std::size_t>(from_)].number + 1
                            : to_ >= 0 ? layout_.cells[static_cast<std::size_t>(to_)].number - n
                                       : 0;
        for (int k = 0; k < n; ++k) {
            const std::uint32_t at = first + 3 * static_cast<std::uint32_t>(k);
            StrandCell cell{.stations = {at, at + 1, at + 2, at + 3},
                            .before = k > 0 ? cells + k - 1 : -1,
                            .behind = k + 1 < n ? cells + k + 1 : -1,
                            .length = length,
                            .seed = seed_of_cell(k),
                            .number = numbers + k,
                            .stroke = number_,
                            .begin_s = points[3 * static_cast<std::size_t>(k)].time_s,
                            .end_s = points[3 * static_cast<std::size_t>(k) + 3].time_s};
            layout_.cells.push_back(cell);
        }
        if (path.closed) link(cells + n - 1, cells, layout_.cells.back().stations[3] = first);
        if (from_ >= 0)
            link(from_, cells, layout_.cells[static_cast<std::size_t>(from_)].stations[3]);
        if (to_ >= 0)
            link(cells + n - 1, to_, layout_.cells[static_cast<std::size_t>(to_)].stations[0]);
    }

    void link(int before, int behind, std::uint32_t station)
    {
        StrandCell &a = layout_.cells[static_cast<std::size_t>(before)],
                   &b = layout_.cells[static_cast<std::size_t>(behind)];
        a.behind = behind;
        b.before = before;
        a.stations[3] = b.stations[0] = station;
    }

    std::uint32_t seed_of_cell(int k) const { return seed_of(stroke_.seed, k); }

    void add_station(const StrandPath& path, const std::optional<SurfacePlace>& place,
                     double length, double cell, const StrandPoint& point)
    {
        StrandStation station;
        station.at = place ? *place : nearest_place(point);
        double lo = length - cell / 8, hi = length + cell / 8;
        if (!path.closed) lo = std::max(0.0, lo), hi = std::min(path.length(), hi);
        station.x = direction_on(path.at(hi).at.p - path.at(lo).at.p, base_.normal(station.at));
        const double much = std::max(thinnest, point.pressure) *
                            std::max(thinnest, 1 - stroke_.taper * length / path.length());
        station.width = cell * stroke_.width * much;
        station.height = stroke_.height * much;
        layout_.stations.push_back(station);
    }

    // A path is on the surface but for rounding: a longer ray finds it.
    SurfacePlace nearest_place(const StrandPoint& point) const
    {
        const std::array<SurfacePoint, 1> one{point.at};
        const auto found = base_.locate(one, base_.diagonal());
        return found[0]                   ? *found[0]
               : layout_.stations.empty() ? SurfacePlace{}
                                          : layout_.stations.back().at;
    }

    StrandLayout& layout_;
    const TileBase& base_;
    const TileStroke& stroke_;
    int number_;
    int from_ = -1, to_ = -1; // cells whose end and whose beginning it joins
};

} // namespace

void add_strand(StrandLayout& layout, const TileBase& base, const TileStroke& stroke, int number,
                std::vector<StrandPoint> points)
{
    StrandBuilder(layout, base, stroke, number).lay(std::move(points));
}

void change_strands(StrandLayout& layout, const TileBase& base, const TileStroke& stroke,
                    const std::vector<StrandPoint>& points)
{
    if (layout.cells.empty()) return;
    // Returns the share of the brush at a station: 1 in its middle, 0 and flat at its rim.
    const auto much_at = [&](const StrandStation& station) {
        const SurfacePoint at{base.position(station.at), base.normal(station.at)};
        double most = 0;
        for (const StrandPoint& each : points) {
            if (same_side(each.at.normal, at.normal))
                most = std::max(most, each.pressure * brush_share(glm::distance(each.at.p, at.p),
                                                                  stroke.radius));
        }
        return most;
    };
    if (stroke.brush == TileBrush::resize || stroke.brush == TileBrush::raise)
        for (StrandStation& each : layout.stations) {
            const double factor = std::exp2(much_at(each) * stroke.strength);
            if (stroke.brush == TileBrush::resize) each.width *= factor;
            each.height *= factor;
        }
    const bool erases = stroke.brush == TileBrush::erase;
    if (!erases && stroke.brush != TileBrush::color && stroke.brush != TileBrush::morph) return;
    for (StrandCell& cell : layout.cells) {
        if (cell.gone) continue;
        const double most = std::max(much_at(layout.stations[cell.stations[1]]),
                                     much_at(layout.stations[cell.stations[2]]));
        if (!(most > 0)) continue;
        if (!erases) {
            change_look(cell.tint, cell.morph, stroke, most * stroke.strength);
            continue;
        }
        cell.gone = true;
        if (cell.before >= 0) layout.cells[static_cast<std::size_t>(cell.before)].behind = -1;
        if (cell.behind >= 0) layout.cells[static_cast<std::size_t>(cell.behind)].before = -1;
        cell.before = cell.behind = -1;
    }
}

} // namespace trivar
