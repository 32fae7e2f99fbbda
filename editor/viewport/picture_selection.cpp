// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/picture_selection.h"

#include <algorithm>

namespace trivar {

void leave_out(gpu::Picture& picture, const std::vector<Id>& ids)
{
    const auto is_out = [&](const auto& each) { return std::ranges::binary_search(ids, each.id); };
    std::erase_if(picture.instances, is_out);
    std::erase_if(picture.curves, is_out);
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

} // namespace trivar
