// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/travel_time.h"

#include "core/placement/journey.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cmath>

namespace trivar {

std::optional<TravelBar> bar_of(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    if (found == session.evaluated().objects.end() || !found->second->journey) return {};
    const Journey& journey = *found->second->journey;
    const Time& time = session.document().time;
    TravelBar bar;
    bar.begin = journey.travel().start_frame;
    bar.endless = !std::isfinite(journey.seconds());
    bar.end = bar.endless ? std::max(bar.begin, 1.0 + time.last_frame)
                          : bar.begin + journey.seconds() * time.frames_per_second;
    return bar;
}

std::optional<Time> time_with_room(const Session& session)
{
    constexpr double latest = 999999; // frame
    Time time = session.document().time;
    double end = 0;
    for (const Id id : travelling(session.document()))
        if (const auto bar = bar_of(session, id); bar && !bar->endless)
            end = std::max(end, bar->end);
    if (end < time.last_frame || time.last_frame >= latest) return {};
    const double rate = time.frames_per_second;
    const double seconds = std::floor((end + 1 - time.first_frame) / rate) + 1;
    time.last_frame =
        static_cast<int>(std::min(latest, std::ceil(time.first_frame - 1 + seconds * rate)));
    return time;
}

} // namespace trivar
