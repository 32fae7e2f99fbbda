// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/volume_words.h"

#include "core/commands/changes.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace trivar {

std::string words_of(const VolumeEdit& edit)
{
    if (edit.press) {
        static constexpr std::array<const char*, 4> decays{"Gaussian", "hat", "box", "smooth"};
        double amount = 0;
        for (const glm::dvec4& sample : edit.press->samples) amount += sample.w;
        return fmt::format("{}, {}, radius {} m", amount < 0 ? "Pull" : "Press",
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
    if (edit.allowance) {
        const std::size_t parts = edit.allowance->boxes.size();
        return parts == 0 ? "May fold nowhere"
                          : fmt::format("May fold in {} {}", parts, parts == 1 ? "part" : "parts");
    }
    if (edit.warp) {
        const Changes found =
            changes(Warp{.axis = edit.warp->axis, .fixed = edit.warp->fixed}, *edit.warp);
        return found.size() == 1 ? found[0].name + " " + found[0].value : "Bent as a whole";
    }
    return "Mended";
}

std::string words_of(const VolumeEdit& edit, const Shaping& done)
{
    return words_of(edit) + (done.words.empty() ? "" : ", " + done.words);
}

std::string words_of(const CellVerdicts& verdicts)
{
    const auto count = [&](Verdict of) { return std::ranges::count(verdicts.of, of); };
    if (const auto bad = count(Verdict::proven_bad); bad > 0)
        return fmt::format("folds in {} of {} cells", bad, verdicts.of.size());
    if (const auto unknown = count(Verdict::unknown); unknown > 0)
        return fmt::format("is not proven to be without folds in {} of {} cells", unknown,
                           verdicts.of.size());
    return count(Verdict::excepted) > 0 ? "folds only where that is allowed, proven"
                                        : "folds nowhere, proven";
}

std::string words_of(const Overlap& overlap)
{
    if (overlap.verdict == Verdict::proven_good) return "meets itself nowhere, proven";
    if (overlap.verdict == Verdict::unknown) return "is not proven to meet itself nowhere";
    const glm::dvec3 &a = overlap.one, &b = overlap.other;
    return fmt::format("meets itself: u, v, w {:.3f}, {:.3f}, {:.3f} and {:.3f}, {:.3f}, {:.3f} "
                       "are one place",
                       a.x, a.y, a.z, b.x, b.y, b.z);
}

} // namespace trivar
