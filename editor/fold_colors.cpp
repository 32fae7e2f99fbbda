// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/fold_colors.h"

namespace trivar {

std::vector<gpu::Translucent> fold_veils(const Lattice& volume, const ui::Palette& color)
{
    constexpr std::size_t most_points = 8000;
    std::vector<gpu::Translucent> veils;
    if (volume.displacement.points.size() > most_points) return veils;
    const CellVerdicts verdicts = judge(volume);
    for (const auto& [verdict, shade] :
         {std::pair(Verdict::proven_bad, color.fold), std::pair(Verdict::unknown, color.warn)}) {
        gpu::Translucent veil =
            veil_of(cells_surface(volume, verdicts, verdict), ui::faded(shade, 0.3f));
        if (!veil.triangles.empty()) veils.push_back(std::move(veil));
    }
    return veils;
}

const std::vector<gpu::Translucent>& FoldColors::of(const Ref<Placement>& placement,
                                                    const ui::Palette& color)
{
    if (placement == placement_ && bad_ == color.fold) return veils_;
    placement_ = placement;
    bad_ = color.fold;
    veils_ = fold_veils(placement->volume, color);
    return veils_;
}

} // namespace trivar
