// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/volume_words.h"

#include "ui/widgets.h"

#include <array>
#include <fmt/format.h>

namespace trivar {

std::string words_of(const VolumeEdit& edit)
{
    if (edit.press) {
        static constexpr std::array<const char*, 4> decays{"Gaussian", "hat", "box", "smooth"};
        double amount = 0;
        for (const glm::dvec4& sample : edit.press->samples) amount += sample.w;
        return fmt::format("{}, {} {} m", amount < 0 ? "Pull" : "Press",
                           decays[static_cast<std::size_t>(edit.press->decay)],
                           ui::short_number(edit.press->radius));
    }
    if (edit.shift)
        return fmt::format("{} moved, {} m",
                           edit.shift->points.size() == 1
                               ? "A point"
                               : std::to_string(edit.shift->points.size()) + " points",
                           ui::short_number(glm::length(edit.shift->by)));
    if (edit.insertion) {
        const KnotInsertion& k = *edit.insertion;
        return fmt::format("{} knots more", k.along.size() + k.across.size() + k.up.size());
    }
    if (edit.coarsening) {
        static constexpr std::array<const char*, 3> axes{"along", "across", "up"};
        return fmt::format("{} points {}", edit.coarsening->count,
                           axes[static_cast<std::size_t>(edit.coarsening->axis)]);
    }
    return "Mended";
}

std::string words_of(const VolumeEdit& edit, const Shaping& done)
{
    return words_of(edit) + (done.words.empty() ? "" : ", " + done.words);
}

} // namespace trivar
