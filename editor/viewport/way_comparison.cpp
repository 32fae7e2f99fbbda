// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/way_comparison.h"

#include "editor/picture/picture.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

void WayComparison::advance(const Evaluation& evaluated, const Document& document,
                            const Ref<gpu::ShaderTexts>& shaders)
{
    if (!running()) return;
    ShownValues none;
    none.lines.effort = LineEffort::quick;
    gpu::Picture picture = picture_of(evaluated, document, {}, none, gpu::DeformBy::two_phases);
    picture.shaders = shaders;
    if (!timer_) timer_ = std::make_unique<gpu::WayTimer>();
    times_[next_] = (*timer_)(picture, static_cast<gpu::DeformBy>(next_));
    ++next_;
}

void WayComparison::forget_gpu()
{
    timer_.reset();
    next_ = deform_words.size();
}

std::vector<ui::TimedWay> WayComparison::rows(const Evaluation& evaluated, gpu::DeformBy used) const
{
    std::vector<ui::TimedWay> rows;
    const auto is_deformed = [](const auto& entry) {
        return std::ranges::any_of(entry.second->parts,
                                   [](const Part& part) { return part.bent != nullptr; });
    };
    if (std::ranges::none_of(evaluated.objects, is_deformed)) return rows;
    for (std::size_t i = 0; i < deform_words.size(); ++i) {
        ui::TimedWay row{deform_words[i].name, deform_words[i].sentence};
        row.used = i == static_cast<std::size_t>(used);
        if (const auto& time = times_[i]) {
            if (!time->why_not.empty()) {
                row.sentence += " " + time->why_not;
                row.off = "cannot";
            } else {
                row.time_ms = time->time_ms;
                row.vertices = time->vertices;
                if (time->off) {
                    row.off = fmt::format("{:.2f}°", time->off->normal_deg);
                    row.sentence += fmt::format(" Off by {:.1e} of the size at most, normals by "
                                                "{:.2f}° at the worst vertex.",
                                                time->off->position, time->off->normal_deg);
                }
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace trivar
