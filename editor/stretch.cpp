// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/stretch.h"

#include "core/ffd/volume_change.h"

#include <algorithm>
#include <cmath>

namespace trivar {

Ref<std::vector<float>> Stretches::of(const Part& part)
{
    if (!part.bent) return nullptr;
    if (const auto found = known_.find(part.bent.get());
        found != known_.end() && found->second.alive.lock() == part.bent)
        return found->second.values;
    std::erase_if(known_, [](const auto& known) { return known.second.alive.expired(); });
    std::vector<float> factors =
        volume_change(*part.before_volume(), part.bent->embedding, *part.bent->volume);
    std::vector<float> sizes(factors.size());
    std::ranges::transform(factors, sizes.begin(), [](float f) { return std::abs(f); });
    const auto middle = sizes.begin() + std::ssize(sizes) / 2;
    std::ranges::nth_element(sizes, middle);
    if (middle != sizes.end() && *middle > 0)
        for (float& f : factors) f /= *middle;
    const auto values = make_ref(std::move(factors));
    known_[part.bent.get()] = {part.bent, values};
    return values;
}

} // namespace trivar
