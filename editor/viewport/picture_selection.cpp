// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/picture_selection.h"

#include <algorithm>

namespace trivar {

void leave_out(gpu::Picture& picture, const std::vector<Id>& ids)
{
    const auto is_out = [&](const auto& each) { return std::ranges::binary_search(ids, each.id); };
    std::erase_if(picture.instances, is_out);
    std::erase_if(picture.curves, is_out);
    std::erase_if(picture.volumes, is_out);
}

void outline_selected(gpu::Picture& picture, const Members& selected)
{
    for (gpu::Curve& curve : picture.curves) curve.highlighted = selected.contain(curve.id);
    for (gpu::Instance& instance : picture.instances) {
        instance.highlighted = selected.contain(instance.id);
        instance.outlined_copies.clear();
        if (instance.highlighted || !instance.copies) continue;
        for (std::uint32_t i = 0; i < instance.copies->size(); ++i)
            if (const int id = (*instance.copies)[i].id; id != 0 && selected.contain(id))
                instance.outlined_copies.push_back(i);
    }
}

gpu::Outline outline_for(const gpu::Picture& picture, gpu::Outline outline)
{
    constexpr float thin = 0.5f; // or it would be more than what it goes round
    const auto has_one = [](const gpu::Instance& instance) {
        return instance.highlighted || !instance.outlined_copies.empty();
    };
    const bool surfaces = std::ranges::any_of(picture.instances, has_one);
    if (surfaces || std::ranges::none_of(picture.curves, &gpu::Curve::highlighted)) return outline;
    outline.width_px *= thin;
    outline.halo_px *= thin;
    return outline;
}

} // namespace trivar
