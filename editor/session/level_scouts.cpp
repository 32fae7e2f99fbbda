// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/level_scouts.h"

#include "core/lines/level_scout.h"
#include "editor/jobs/job.h"

#include <utility>

namespace trivar {
namespace {

ScoutedVolume shown_scout(const LevelScout& scout)
{
    ScoutedVolume out;
    for (std::size_t i = 0; i < scout.values.size(); ++i)
        out.curve.emplace_back(scout.values[i], scout.lengths[i]);
    for (const std::size_t i : scout.plateaus) out.plateaus.push_back(scout.values[i]);
    return out;
}

} // namespace

const ScoutedVolume* LevelScouts::of(Jobs& jobs, const ShownVolume& volume)
{
    if (!volume.summary || !volume.data) return nullptr;
    const Found& found = known_(volume.summary, [&] {
        Found slot = std::make_shared<std::optional<ScoutedVolume>>();
        jobs.start({"Looking for levels",
                    [slot, data = volume.data](const Progress& progress) -> Jobs::Finish {
                        return
                            [slot, scouted = shown_scout(scout_levels(*data, 64, 64, progress))] {
                                *slot = scouted;
                            };
                    },
                    {}});
        return slot;
    });
    return *found ? &**found : nullptr;
}

} // namespace trivar
