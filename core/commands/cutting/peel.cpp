// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/peel.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/entry_tracks.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

Document applied(Document document, const PeelFlap& command)
{
    const PeeledFlap flap = in_order(command.flap);
    incision_index(document, command.object, flap.first);
    incision_index(document, command.object, flap.second);
    if (flap.first == flap.second)
        throw Rejected("fields \"first\" and \"second\" must name two different incisions");
    const std::vector<PeeledFlap>& before = incising_of(document, command.object).flaps;
    const auto same = [&](const PeeledFlap& each) { return each.same_place(flap); };
    const auto found = std::ranges::find_if(before, same) - before.begin();
    const auto index = static_cast<std::size_t>(found);
    if (index == before.size() && index >= most_peeled_flaps)
        throw Rejected(fmt::format("{} has {} peeled flaps already; at most {} are taken",
                                   named(document, command.object), index, most_peeled_flaps));
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<PeeledFlap>& flaps = o.incising->flaps;
        if (index == flaps.size())
            flaps.push_back(flap);
        else
            flaps[index] = flap;
    });
}

StepTitle title(const PeelFlap& c, const StepDocuments& step)
{
    return {"Peel a flap of " + names_in(step.before, {c.object}),
            with_unit(c.flap.lift, Unit::metres)};
}

Document applied(Document document, const LayFlap& command)
{
    const std::size_t count = incising_of(document, command.object).flaps.size();
    const std::size_t index =
        entry_index(document, command.object, count, command.number, "peeled flaps");
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<char> gone(count, 0);
        gone[index] = 1;
        o.tracks = without_entries(o.tracks, "incising.flaps.", gone);
        o.incising->flaps.erase(o.incising->flaps.begin() + static_cast<long>(index));
    });
}

StepTitle title(const LayFlap& c, const StepDocuments& step)
{
    return {fmt::format("Lay flap {} of {} back", c.number, names_in(step.before, {c.object})), {}};
}

} // namespace trivar
