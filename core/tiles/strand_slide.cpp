// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand_slide.h"

#include <cmath>

namespace trivar {
namespace {

// A slide that near to a whole number of cells is one.
constexpr double whole_cells = 1e-6;

class StrandSlider {
public:
    StrandSlider(const StrandLayout& layout, std::span<const StrandNodes> nodes,
                 std::span<const double> heights, double cells)
        : layout_(layout),
          nodes_(nodes),
          heights_(heights),
          even_(heights.size(), 1),
          whole_(std::floor(cells)),
          share_(cells - whole_)
    {
        if (share_ > 1 - whole_cells) ++whole_;
        if (share_ < whole_cells || share_ > 1 - whole_cells) share_ = 0;
        out_.layout = layout;
        out_.layout.cells.clear();
        out_.nodes.assign(nodes.begin(), nodes.end());
        out_.heights.assign(heights.begin(), heights.end());
    }

    SlidStrands slide()
    {
        std::vector<char> done(layout_.cells.size(), 0);
        const auto follow = [&](std::size_t from, bool closed) {
            std::vector<std::uint32_t> chain;
            for (int c = static_cast<int>(from); c >= 0 && !done[static_cast<std::size_t>(c)];
                 c = layout_.cells[static_cast<std::size_t>(c)].behind) {
                done[static_cast<std::size_t>(c)] = 1;
                chain.push_back(static_cast<std::uint32_t>(c));
            }
            slide_chain(chain, closed);
        };
        for (std::size_t c = 0; c < done.size(); ++c)
            if (layout_.cells[c].before < 0) follow(c, false);
        for (std::size_t c = 0; c < done.size(); ++c)
            if (!done[c]) follow(c, true);
        return std::move(out_);
    }

private:
    void slide_chain(const std::vector<std::uint32_t>& chain, bool closed)
    {
        const auto n = static_cast<double>(chain.size());
        const bool ends = !closed && share_ > 0; // tiles leave and come in
        const std::size_t count = chain.size() + (ends ? 1 : 0), first = out_.layout.cells.size();
        station_from_ = ~0u;
        std::uint32_t begin_station = 0;
        for (std::size_t q = 0; q < count; ++q) {
            // The place that the tile takes, in cells of the chain; of a closed one it may reach
            // beyond its end by less than a cell.
            double from = static_cast<double>(q) + (ends ? share_ - 1 : share_), to = from + 1;
            if (ends) from = std::max(0.0, from), to = std::min(n, to);
            const double index = static_cast<double>(q) - (ends ? 1 : 0) - whole_;
            const double rounds = std::floor(index / n);
            const StrandCell& tile =
                layout_.cells[chain[static_cast<std::size_t>(index - rounds * n)]];
            StrandCell cell = cell_on(chain, from, to);
            cell.seed = tile.seed;
            cell.number = tile.number + static_cast<int>(rounds * n);
            cell.gone = tile.gone;
            cell.tint = tile.tint;
            cell.morph = tile.morph;
            cell.morph_factor = tile.morph_factor;
            const bool joins = closed && q + 1 == count;
            cell.stations[0] = q == 0 ? station_at(chain, from) : station_from_;
            if (q == 0) begin_station = cell.stations[0];
            cell.stations[1] = station_at(chain, from + patch_nodes[1] * (to - from));
            cell.stations[2] = station_at(chain, from + patch_nodes[2] * (to - from));
            cell.stations[3] = joins ? begin_station : station_at(chain, to);
            station_from_ = cell.stations[3];
            const auto number = static_cast<int>(first + q);
            cell.before = q > 0 ? number - 1 : closed ? number + static_cast<int>(count) - 1 : -1;
            cell.behind = q + 1 < count ? number + 1 : closed ? static_cast<int>(first) : -1;
            out_.layout.cells.push_back(cell);
        }
    }

    struct Spot { // a place of a chain
        std::uint32_t cell;
        double x;
    };
    static Spot spot_at(const std::vector<std::uint32_t>& chain, double t)
    {
        const auto n = static_cast<double>(chain.size());
        double k = std::floor(t);
        const double x = t - k;
        if (k >= n && x > 0) k -= n; // round
        if (k < n) return {chain[static_cast<std::size_t>(k)], x};
        return {chain.back(), 1};
    }

    // The cell with the time, the length and the stroke of the place that it takes.
    StrandCell cell_on(const std::vector<std::uint32_t>& chain, double from, double to)
    {
        const double middle = std::floor(from) + 1;
        const Spot a = spot_at(chain, from),
                   b = middle < to ? spot_at(chain, middle + (to - middle) / 2) : a,
                   end = middle < to ? spot_at(chain, to) : Spot{a.cell, to - std::floor(from)};
        const StrandCell &first = layout_.cells[a.cell], &last = layout_.cells[b.cell];
        StrandCell cell = first;
        cell.length = middle < to ? (middle - from) * first.length + (to - middle) * last.length
                                  : (to - from) * first.length;
        const double from_share = a.x, to_share = middle < to ? to - middle : end.x;
        cell.begin_s = std::lerp(first.begin_s, first.end_s, from_share);
        cell.end_s = std::lerp(last.begin_s, last.end_s, to_share);
        out_.lies_on.push_back({a.cell, b.cell});
        return cell;
    }

    // The station there: that of the strands as they were laid, or a new one on their patches.
    std::uint32_t station_at(const std::vector<std::uint32_t>& chain, double t)
    {
        const Spot spot = spot_at(chain, t);
        const StrandCell& cell = layout_.cells[spot.cell];
        for (std::size_t k = 0; k < 4; ++k)
            if (spot.x == patch_nodes[k]) return cell.stations[k];
        if (spot.cell != patched_) {
            patched_ = spot.cell;
            patch_ = strand_patch(layout_, spot.cell, nodes_, even_, false);
        }
        StrandNodes nodes;
        for (std::size_t j = 0; j < 4; ++j) {
            const TilePoint at = tile_point(patch_, {spot.x, patch_nodes[j], 0});
            const double length = glm::length(at.z);
            nodes[j] = {at.p, length > 0 ? at.z / length : nodes_[cell.stations[0]][j].normal};
        }
        std::size_t k = 0;
        while (k < 2 && spot.x > patch_nodes[k + 1]) ++k;
        const double share = (spot.x - patch_nodes[k]) / (patch_nodes[k + 1] - patch_nodes[k]);
        out_.heights.push_back(
            std::lerp(heights_[cell.stations[k]], heights_[cell.stations[k + 1]], share));
        out_.nodes.push_back(nodes);
        out_.layout.stations.push_back(layout_.stations[cell.stations[share < 0.5 ? k : k + 1]]);
        return static_cast<std::uint32_t>(out_.nodes.size() - 1);
    }

    const StrandLayout& layout_;
    std::span<const StrandNodes> nodes_;
    std::span<const double> heights_;
    std::vector<double> even_; // of all stations
    double whole_, share_;     // of the slide
    SlidStrands out_;
    std::uint32_t station_from_ = ~0u, patched_ = ~0u;
    TilePatch patch_;
};

} // namespace

SlidStrands slid_strands(const StrandLayout& layout, std::span<const StrandNodes> nodes,
                         std::span<const double> heights, double cells)
{
    return StrandSlider(layout, nodes, heights, cells).slide();
}

} // namespace trivar
