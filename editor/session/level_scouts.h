// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/shown_volume.h"

#include <memory>
#include <optional>
#include <vector>

namespace trivar {

class Jobs;

// A ScoutedVolume is what scout_levels() tells of volume data, as a histogram shows it and a
// dragged level halts by it.
struct ScoutedVolume {
    std::vector<glm::dvec2> curve; // (value, length of the lines there), by ascending values
    std::vector<double> plateaus;  // values, ascending
};

// LevelScouts keeps what was scouted of the last few volumes. It is found beside the window, in
// about a second per volume. Frame thread only.
class LevelScouts {
public:
    // Null: not known yet, and looked for from now on.
    const ScoutedVolume* of(Jobs& jobs, const ShownVolume& volume);

private:
    // Volumes are known by their summaries, which are made once per content that was read.
    using Found = std::shared_ptr<std::optional<ScoutedVolume>>;
    Recent<Ref<VolumeSummary>, Found> known_{8};
};

} // namespace trivar
