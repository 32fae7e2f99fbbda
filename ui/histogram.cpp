// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/histogram.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trivar::ui {

float ValueScale::x(double value) const
{
    const double share = hi > lo ? std::clamp((value - lo) / (hi - lo), 0.0, 1.0) : 0.5;
    return rect.lo.x + static_cast<float>(share) * rect.width();
}

double ValueScale::value(float x) const
{
    const double share = static_cast<double>((x - rect.lo.x) / rect.width());
    return std::clamp(lo + share * (hi - lo), lo, hi);
}

double ValueScale::per_px() const
{
    return (hi - lo) / std::max(1.0, static_cast<double>(rect.width()));
}

void paint_histogram(const Theme& theme, const ValueScale& scale,
                     std::span<const std::uint64_t> counts)
{
    if (counts.empty()) return;
    const float pitch = std::max(2.0f, std::round(theme.px(3))), gap = theme.size.hairline;
    const int bars = std::max(1, static_cast<int>(scale.rect.width() / pitch));
    std::vector<double> heights(static_cast<std::size_t>(bars), 0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto bar = i * heights.size() / counts.size();
        heights[bar] += static_cast<double>(counts[i]);
    }
    // Where there are more bars than parts each part has several.
    if (heights.size() > counts.size())
        for (std::size_t bar = 0; bar < heights.size(); ++bar)
            heights[bar] = static_cast<double>(counts[bar * counts.size() / heights.size()]);
    double most = 0;
    for (double& height : heights) {
        height = std::log1p(height);
        most = std::max(most, height);
    }
    if (most <= 0) return;
    const float each = scale.rect.width() / static_cast<float>(bars);
    for (std::size_t bar = 0; bar < heights.size(); ++bar) {
        const float tall = static_cast<float>(heights[bar] / most) * scale.rect.height();
        const float a = std::round(scale.rect.lo.x + static_cast<float>(bar) * each),
                    b = std::round(scale.rect.lo.x + static_cast<float>(bar + 1) * each) - gap;
        if (tall > 0)
            paint_box(
                {{a, std::round(scale.rect.hi.y - std::max(1.0f, tall))}, {b, scale.rect.hi.y}},
                theme.color.text_off);
    }
}

} // namespace trivar::ui
