// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/cut.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/entry_tracks.h"
#include "core/split/cut_sheet.h"

#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::string_view cut_tracks = "cutting.cuts.";

const Cutting& cutting_of(const Document& document, Id id)
{
    const Object& own = object(document, id);
    if (!own.cutting) throw Rejected(named(id, own) + " is not cut");
    return *own.cutting;
}

Document made_whole(Document document, Id id)
{
    return with_changed(std::move(document), id, [](Object& o) {
        if (!o.cutting) return;
        o.tracks =
            without_entries(o.tracks, cut_tracks, std::vector<char>(o.cutting->cuts.size(), 1));
        o.cutting.reset();
    });
}

} // namespace

void check(const Cutting& cutting)
{
    if (cutting.cuts.empty()) throw Rejected("field \"cuts\" is empty; name a plane or a stroke");
    if (cutting.cuts.size() > most_cuts)
        throw Rejected(fmt::format("field \"cuts\" has {} entries but at most {} are taken; remove "
                                   "one, or export the pieces and cut these",
                                   cutting.cuts.size(), most_cuts));
    for (std::size_t i = 0; i < cutting.cuts.size(); ++i) {
        const PlainCut& cut = cutting.cuts[i];
        if (cut.opened.size() > i)
            throw Rejected(
                fmt::format("field \"opened\" of cut {} has {} entries, but there are only "
                            "{} cuts before it",
                            i + 1, cut.opened.size(), i));
        if (!cut.cuts()) throw Rejected("field \"normal\" has no direction");
        if (cut.stroke.size() > most_cut_points)
            throw Rejected(fmt::format("field \"stroke\" has {} points but at most {} are taken",
                                       with_commas(cut.stroke.size()),
                                       with_commas(most_cut_points)));
        if (const std::string why = stroke_trouble(cut.stroke); !why.empty())
            throw Rejected("field \"stroke\": " + why);
        const double across = glm::length(glm::cross(cut.normal, cut.along));
        if (!cut.stroke.empty() &&
            !(across > 1e-6 * glm::length(cut.normal) * glm::length(cut.along)))
            throw Rejected("fields \"normal\" and \"along\" must be two different directions");
    }
}

Document applied(Document document, const CutThrough& command)
{
    check(command.cutting);
    for (const Id id : distinct(document, command.objects)) check_has_surface(document, id, "cut");
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.cutting = command.cutting; });
}

StepTitle title(const CutThrough& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, c.objects);
    if (c.objects.size() != 1) return {"Cut through " + of, {}};
    const Object& before = object(step.before, c.objects.front());
    if (!before.cutting || before.cutting->cuts.size() < c.cutting.cuts.size())
        return {"Cut through " + of, {}};
    return {"Change the cuts of " + of, {}};
}

Document applied(Document document, const RemoveCut& command)
{
    const std::size_t count = cutting_of(document, command.object).cuts.size();
    const std::size_t index = entry_index(document, command.object, count, command.number, "cuts");
    if (count == 1) return made_whole(std::move(document), command.object);
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<char> gone(count, 0);
        gone[index] = 1;
        o.tracks = without_entries(o.tracks, cut_tracks, gone);
        o.cutting->cuts.erase(o.cutting->cuts.begin() + (command.number - 1));
        for (PlainCut& cut : o.cutting->cuts)
            if (static_cast<std::size_t>(command.number) <= cut.opened.size())
                cut.opened.erase(cut.opened.begin() + (command.number - 1));
    });
}

StepTitle title(const RemoveCut& c, const StepDocuments& step)
{
    return {fmt::format("Remove cut {} of {}", c.number, names_in(step.before, {c.object})), {}};
}

Document applied(Document document, const ClearCuts& command)
{
    for (const Id id : distinct(document, command.objects))
        document = made_whole(std::move(document), id);
    return document;
}

} // namespace trivar
