// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/height_map.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/placement/profile.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

HeightMap::Axis::Axis(std::size_t count)
    : knots(Knots::uniform(std::min(3, static_cast<int>(count)), static_cast<int>(count)))
{
    for (int i = 0; i < knots.count(); ++i) sites.push_back(knots.greville(i));
}

Basis HeightMap::Axis::at(double t) const
{
    return basis(knots, std::clamp(t, 0.0, 1.0));
}

HeightMap::HeightMap(const HeightGrid& grid)
{
    if (grid.empty()) return;
    check_height_map(grid, "the height map");
    along_ = Axis(grid.size());
    across_ = Axis(grid.front().size());
    even_ = largest_ = grid.front().front();
    bool same = true;
    for (const std::vector<double>& row : grid)
        for (const double value : row) {
            largest_ = std::max(largest_, value);
            same = same && value == even_;
        }
    if (!same) grid_ = grid;
}

double HeightMap::at(double u, double v) const
{
    if (grid_.empty()) return even_;
    const Basis a = along_.at(u), b = across_.at(v);
    double sum = 0;
    for (int i = 0; i < along_.knots.order(); ++i)
        for (int j = 0; j < across_.knots.order(); ++j) {
            const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
            sum +=
                a.value[I] * b.value[J] *
                grid_[static_cast<std::size_t>(a.first) + I][static_cast<std::size_t>(b.first) + J];
        }
    return sum;
}

double HeightMap::weight(int i, int j) const
{
    const auto own = [](const Axis& axis, int k) {
        const Basis b = axis.at(axis.sites[static_cast<std::size_t>(k)]);
        return b.value[static_cast<std::size_t>(k - b.first)];
    };
    return own(along_, i) * own(across_, j);
}

HeightGrid resampled(const HeightGrid& grid, int along, int across)
{
    const HeightMap before(grid);
    HeightGrid out(static_cast<std::size_t>(along),
                   std::vector<double>(static_cast<std::size_t>(across), 1));
    const HeightMap after(out);
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t j = 0; j < out[i].size(); ++j)
            out[i][j] = before.at(after.along()[i], after.across()[j]);
    return out;
}

void check_height_map(const HeightGrid& grid, const std::string& name)
{
    if (grid.empty()) return;
    const auto counted = [&](std::size_t count, const char* way) {
        if (count < least_map_points || count > most_map_points)
            throw Rejected(fmt::format("{} has {} values {} the stroke, but must have {} to {}",
                                       name, count, way, least_map_points, most_map_points));
    };
    counted(grid.size(), "along");
    counted(grid.front().size(), "across");
    for (const std::vector<double>& row : grid) {
        if (row.size() != grid.front().size())
            throw Rejected(
                fmt::format("{} has rows of {} and of {} values, but all must be equally long",
                            name, grid.front().size(), row.size()));
        for (const double value : row)
            if (!(value >= least_profile && value <= most_profile))
                throw Rejected(
                    fmt::format("{} has the factor {}, but factors must be from {} to {}", name,
                                number_text(value, {.digits = 6}), number_text(least_profile),
                                number_text(most_profile)));
    }
}

} // namespace trivar
