// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/remaining_edits.h"

#include <algorithm>

namespace trivar {

RemainingEdits without_edit(std::vector<TetrahedraEdit> edits, std::size_t index)
{
    RemainingEdits out{{}, std::vector<char>(edits.size(), 0)};
    out.gone[index] = 1;
    if (edits[index].refinement) {
        const auto end = edits.begin() + static_cast<std::ptrdiff_t>(index) + 1;
        const auto layer = std::count_if(
            edits.begin(), end, [](const TetrahedraEdit& edit) { return !!edit.refinement; });
        for (std::size_t i = 0; i < edits.size(); ++i) {
            if (!edits[i].pull) continue;
            if (edits[i].pull->layer == layer) out.gone[i] = 1;
            if (edits[i].pull->layer > layer) --edits[i].pull->layer;
        }
    }
    for (std::size_t i = 0; i < edits.size(); ++i)
        if (out.gone[i] == 0) out.edits.push_back(std::move(edits[i]));
    return out;
}

} // namespace trivar
