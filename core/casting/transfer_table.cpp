// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/transfer_table.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/color_space.hpp>

namespace trivar {

TransferTable transfer_table(std::span<const TransferPoint> points, double least, double greatest)
{
    constexpr double most_opaque = 0.9999; // what is quite opaque needs an infinite density
    TransferTable out{least, greatest, {glm::vec4(0)}};
    out.before.reserve(TransferTable::cells + 1);
    std::vector<TransferPoint> ordered(points.begin(), points.end());
    std::ranges::stable_sort(ordered, {}, &TransferPoint::value);
    glm::dvec4 sum(0);
    for (int i = 0; i < TransferTable::cells; ++i) {
        const double share = (i + 0.5) / TransferTable::cells;
        const glm::vec4 look = transfer_at(ordered, least + (greatest - least) * share);
        const double density = -std::log1p(-std::min<double>(look.a, most_opaque));
        const glm::dvec3 color = glm::convertSRGBToLinear(glm::dvec3(look));
        sum += glm::dvec4(color, 1) * density / static_cast<double>(TransferTable::cells);
        out.before.emplace_back(sum);
    }
    return out;
}

bool TransferTable::empty(double low, double high) const
{
    const auto entry = [&](double at) {
        return before[static_cast<std::size_t>(std::clamp(at, 0.0, double{cells}))].a;
    };
    return entry(std::floor(low * cells) - 1) == entry(std::ceil(high * cells) + 1);
}

} // namespace trivar
