// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/volume_facts.h"

#include "core/ffd/resolution.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t most_points = 8000; // that are looked at between two frames

std::optional<CellVerdicts> judged(const Lattice& volume)
{
    if (volume.displacement.points.size() > most_points) return {};
    return judge(volume);
}

std::vector<gpu::Translucent> veils_of(const Lattice& volume, const CellVerdicts& verdicts,
                                       const ui::Palette& color)
{
    std::vector<gpu::Translucent> veils;
    for (const auto& [verdict, shade] :
         {std::pair(Verdict::proven_bad, color.fold), std::pair(Verdict::unknown, color.warn)}) {
        gpu::Translucent veil =
            veil_of(cells_surface(volume, verdicts, verdict), ui::faded(shade, 0.3f));
        if (!veil.triangles.empty()) veils.push_back(std::move(veil));
    }
    return veils;
}

} // namespace

int fewer_points(const Knots& axis)
{
    return std::max(axis.order(), axis.count() * 3 / 4);
}

std::vector<gpu::Translucent> fold_veils(const Lattice& volume, const ui::Palette& color)
{
    const std::optional<CellVerdicts> verdicts = judged(volume);
    return verdicts ? veils_of(volume, *verdicts, color) : std::vector<gpu::Translucent>{};
}

void VolumeFacts::judge_again(const Ref<Placement>& placement)
{
    if (placement == placement_) return;
    placement_ = placement;
    verdicts_ = judged(placement->volume);
    bad_ = 0;
}

const std::vector<gpu::Translucent>& VolumeFacts::folds(const Ref<Placement>& placement,
                                                        const ui::Palette& color)
{
    judge_again(placement);
    if (bad_ == color.fold) return veils_;
    bad_ = color.fold;
    veils_ = verdicts_ ? veils_of(placement->volume, *verdicts_, color)
                       : std::vector<gpu::Translucent>{};
    return veils_;
}

const std::array<std::optional<double>, 3>& VolumeFacts::deviations(const Ref<Placement>& placement)
{
    if (placement == coarsened_) return deviations_;
    coarsened_ = placement;
    const Lattice& volume = placement->volume;
    for (int axis = 0; axis < 3; ++axis) {
        std::optional<double>& deviation = deviations_[static_cast<std::size_t>(axis)];
        deviation.reset();
        const Knots& knots = volume.displacement.axes[static_cast<std::size_t>(axis)];
        const int fewer = fewer_points(knots);
        if (volume.displacement.points.size() <= most_points && knots.closure() == Closure::open &&
            fewer < knots.count())
            deviation = coarsened(volume, axis, fewer).deviation;
    }
    return deviations_;
}

const CellVerdicts* VolumeFacts::verdicts(const Ref<Placement>& placement)
{
    judge_again(placement);
    return verdicts_ ? &*verdicts_ : nullptr;
}

} // namespace trivar
