// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/lines_at_rest.h"

#include "core/base/number_text.h"
#include "core/stages/shown_volume.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double rest_s = 0.3; // as pictures at rest wait

// Whether a level with certified lines is seen for which that holds.
bool any_certified(const LineScene& scene, auto&& holds)
{
    return std::ranges::any_of(scene.objects, [&](const LineScene::Object& object) {
        return object.volume_to_world &&
               std::ranges::any_of(object.effects->shape->volume->levels,
                                   [&](const ShownVolume::Level& level) {
                                       return level.lines && level.certified && holds(level);
                                   });
    });
}

std::string words_of_proof(const ProofGaps& gaps, const std::string& to, bool share)
{
    std::string out = fmt::format("Lines certified {}{}, {} box{} open", to,
                                  share ? " before their share is taken" : "",
                                  with_commas(gaps.open), gaps.open == 1 ? "" : "es");
    if (gaps.loose_ends > 0)
        out += fmt::format(", {} loose end{}", with_commas(gaps.loose_ends),
                           gaps.loose_ends == 1 ? "" : "s");
    return out;
}

} // namespace

void LinesAtRest::follow(const Seen& seen, bool moving, double time_s, PictureLines& into)
{
    into.effort = LineEffort::quick;
    into.hidden_here = seen.hidden_here;
    now_s_ = time_s;
    LineScene wanted = line_scene(seen.evaluated, seen.document, seen.camera, seen.hidden_here);
    if (wanted.is_simple()) wanted.objects.clear();
    if (wanted != wanted_) {
        work_.drop();
        into.give({}, nullptr);
        wanted_ = std::move(wanted);
        asked_ = done_ = false;
        moved_s_ = time_s;
    }
    work_.poll();
    if (moving) moved_s_ = time_s;
    if (wanted_.objects.empty() || asked_ || time_s - moved_s_ < rest_s) return;
    asked_ = true;
    work_.start([this, &into, scene = wanted_,
                 drawer = drawer_](const Progress& progress) -> Worker::Finish {
        Ref<SceneLines> lines = make_ref((*drawer)(scene, {.progress = progress}));
        return [this, &into, scene, lines] {
            into.give(scene, lines);
            lines_ = lines;
            done_ = true;
            ++number_;
        };
    });
}

std::optional<double> LinesAtRest::again_in_s() const
{
    constexpr double soon_s = 0.05;
    if (busy()) return soon_s;
    if (wanted_.objects.empty() || asked_) return {};
    return std::max(soon_s, rest_s - (now_s_ - moved_s_) + 0.01);
}

std::string LinesAtRest::words() const
{
    if (wanted_.objects.empty() || (asked_ && !done_ && !busy())) return {};
    const std::string to = fmt::format("to 1/{} voxel", 1 << certified_halvings);
    const bool certified = any_certified(wanted_, [](const ShownVolume::Level&) { return true; });
    if (!done_) return certified ? "Certifying lines " + to : "Drawing lines";
    std::vector<std::string> out = lines_->notices;
    if (certified)
        out.insert(out.begin(),
                   words_of_proof(lines_->gaps, to,
                                  any_certified(wanted_, [](const ShownVolume::Level& level) {
                                      return level.more.amount < 1;
                                  })));
    return fmt::format("{}", fmt::join(out, "; "));
}

} // namespace trivar
