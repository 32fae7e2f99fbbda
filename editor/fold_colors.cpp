// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/fold_colors.h"

namespace trivar {

const std::vector<gpu::Translucent>& FoldColors::of(const Ref<Placement>& placement,
                                                    const ui::Theme& theme)
{
    if (placement == placement_ && bad_ == theme.color.fold) return veils_;
    placement_ = placement;
    bad_ = theme.color.fold;
    veils_.clear();
    constexpr std::size_t most_points = 8000;
    const Lattice& volume = placement->volume;
    if (volume.displacement.points.size() > most_points) return veils_;
    const CellVerdicts verdicts = judge(volume);
    for (const auto& [verdict, color] : {std::pair(Verdict::proven_bad, theme.color.fold),
                                         std::pair(Verdict::unknown, theme.color.warn)}) {
        gpu::Translucent veil =
            veil_of(cells_surface(volume, verdicts, verdict), ui::faded(color, 0.45f));
        if (!veil.triangles.empty()) veils_.push_back(std::move(veil));
    }
    return veils_;
}

} // namespace trivar
