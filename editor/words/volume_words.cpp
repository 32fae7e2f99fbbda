// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/volume_words.h"

#include "core/commands/words/changes.h"
#include "core/document/fields/shaping_fields.h"
#include "core/placement/warping.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace trivar {

std::string words_of(const VolumeEdit& edit, bool box)
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
        const std::size_t more = k.along.size() + k.across.size() + k.up.size();
        return more == 1 ? "1 more knot" : fmt::format("{} more knots", more);
    }
    if (edit.coarsening) {
        static constexpr std::array<const char*, 3> of_box{"along X", "along Y", "along Z"},
            of_stroke{"along the stroke", "across it", "upward"};
        const auto axis = static_cast<std::size_t>(edit.coarsening->axis);
        return fmt::format("Coarsened to {} points {}", edit.coarsening->count,
                           box ? of_box[axis] : of_stroke[axis]);
    }
    if (edit.allowance) {
        const std::size_t parts = edit.allowance->boxes.size();
        return parts == 0 ? "May fold nowhere"
                          : fmt::format("May fold in {} {}", parts, parts == 1 ? "part" : "parts");
    }
    if (edit.warp) {
        const Changes found =
            changes(Warp{.axis = edit.warp->axis, .fixed = edit.warp->fixed}, *edit.warp);
        if (found.empty() || found.size() > 3) return "Bent as a whole";
        std::string words;
        for (const Change& each : found)
            words += (words.empty() ? "" : ", ") + each.name + " " + each.value;
        return words;
    }
    return "Folds repaired";
}

VolumeEdit as_done(VolumeEdit edit, const Shaping& done)
{
    if (!done.would_fold) return edit;
    const double share = done.asked != 0 ? done.done / done.asked : 0;
    if (edit.warp) edit.warp = part_of(*edit.warp, share);
    const bool moves = edit.shift && edit.shift->rotation_deg == glm::dvec3(0) &&
                       edit.shift->factors == glm::dvec3(1);
    if (moves) edit.shift->by *= share;
    return edit;
}

std::string words_of(const VolumeEdit& edit, bool box, const Shaping& done)
{
    return words_of(as_done(edit, done), box) + (done.words.empty() ? "" : ", " + done.words);
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
