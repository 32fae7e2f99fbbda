// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace trivar {

// A ValueRange says at which share of the range of many values one is, without the outermost
// twentieth of them on each side.
class ValueRange {
public:
    explicit ValueRange(std::vector<float> values)
    {
        constexpr float outermost = 0.05f;
        if (values.empty()) return;
        const auto at = [&](float share) {
            const auto i =
                static_cast<std::ptrdiff_t>(share * static_cast<float>(values.size() - 1));
            std::nth_element(values.begin(), values.begin() + i, values.end());
            return values[static_cast<std::size_t>(i)];
        };
        least_ = at(outermost);
        greatest_ = at(1 - outermost);
    }
    float share(float value) const // 0 .. 1; 0.5 where all values are the same
    {
        return greatest_ > least_ ? std::clamp((value - least_) / (greatest_ - least_), 0.0f, 1.0f)
                                  : 0.5f;
    }

private:
    float least_ = 0, greatest_ = 0;
};

} // namespace trivar
