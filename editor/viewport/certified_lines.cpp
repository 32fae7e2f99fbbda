// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/certified_lines.h"

#include "core/base/number_text.h"
#include "core/stages/shown_volume.h"
#include "editor/picture/picture.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double rest_s = 0.3; // as pictures at rest wait

std::vector<VolumeView> views_to_certify(const CertifiedLines::Seen& seen)
{
    std::vector<VolumeView> out;
    for (const auto& [id, object] : seen.evaluated.objects) {
        if (!object->shape || !object->shape->volume || !object->shape->volume->certifies())
            continue;
        const auto own = seen.document.objects.find(id);
        if (own == seen.document.objects.end() || own->second->stroke) continue;
        if (std::ranges::binary_search(seen.hidden_here, id)) continue;
        out.push_back({object->shape->volume, to_world(seen.document, id), seen.camera, id});
    }
    return out;
}

// Whether certified lines are seen of which some were left out.
bool shows_a_share(const ShownVolume& volume)
{
    return std::ranges::any_of(volume.levels, [](const ShownVolume::Level& level) {
        return level.lines && level.certified && level.more.amount < 1;
    });
}

} // namespace

void CertifiedLines::follow(const Seen& seen, bool moving, double time_s, VolumeLines& into)
{
    into.proof = LineProof::none;
    now_s_ = time_s;
    std::vector<VolumeView> wanted = views_to_certify(seen);
    if (wanted != wanted_) {
        work_.drop();
        into.give({});
        wanted_ = std::move(wanted);
        asked_ = done_ = false;
        moved_s_ = time_s;
    }
    work_.poll();
    if (moving) moved_s_ = time_s;
    if (wanted_.empty() || asked_ || time_s - moved_s_ < rest_s) return;
    asked_ = true;
    work_.start([this, &into, views = wanted_](const Progress& progress) -> Worker::Finish {
        VolumeLines::Given lines;
        ProofGaps gaps;
        for (const VolumeView& view : views) {
            lines.emplace_back(
                view, lines_of(view, wider_lines(view.camera), LineProof::as_wanted, progress));
            gaps.open += lines.back().second.gaps.open;
            gaps.loose_ends += lines.back().second.gaps.loose_ends;
        }
        return [this, &into, lines = std::move(lines), gaps]() mutable {
            into.give(std::move(lines));
            gaps_ = gaps;
            done_ = true;
            ++number_;
        };
    });
}

std::optional<double> CertifiedLines::again_in_s() const
{
    constexpr double soon_s = 0.05;
    if (busy()) return soon_s;
    if (wanted_.empty() || asked_) return {};
    return std::max(soon_s, rest_s - (now_s_ - moved_s_) + 0.01);
}

std::string CertifiedLines::words() const
{
    if (wanted_.empty() || (asked_ && !done_ && !busy())) return {};
    const std::string to = fmt::format("to 1/{} voxel", 1 << certified_halvings);
    if (!done_) return "Certifying lines " + to;
    const bool share = std::ranges::any_of(
        wanted_, [](const VolumeView& each) { return shows_a_share(*each.volume); });
    std::string out = fmt::format("Lines certified {}{}, {} box{} open", to,
                                  share ? " before their share is taken" : "",
                                  with_commas(gaps_.open), gaps_.open == 1 ? "" : "es");
    if (gaps_.loose_ends > 0)
        out += fmt::format(", {} loose end{}", with_commas(gaps_.loose_ends),
                           gaps_.loose_ends == 1 ? "" : "s");
    return out;
}

} // namespace trivar
