// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/incise.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/entry_tracks.h"
#include "core/commands/words/changes.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::string_view incision_tracks = "incising.cuts.", flap_tracks = "incising.flaps.";

std::string called(const NamedIncision& incision, int number)
{
    return incision.name.empty() ? fmt::format("incision {}", number) : incision.name;
}

void check_profile(std::string_view name, const IncisionProfile& profile)
{
    if (profile.shape == IncisionProfile::Shape::custom && profile.points.size() < 2)
        throw Rejected(fmt::format("field \"{}\" has {} points; a custom profile has two at least",
                                   name, profile.points.size()));
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const glm::dvec2 p = profile.points[i];
        if (!(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1))
            throw Rejected(
                fmt::format("field \"{}\" has a point that is not between 0 and 1", name));
        if (i > 0 && !(p.x >= profile.points[i - 1].x))
            throw Rejected(fmt::format("field \"{}\" has points that go back", name));
    }
}

Document without_incisions(Document document, Id id)
{
    return with_changed(std::move(document), id, [](Object& o) {
        if (!o.incising) return;
        o.tracks = without_entries(o.tracks, incision_tracks,
                                   std::vector<char>(o.incising->cuts.size(), 1));
        o.tracks =
            without_entries(o.tracks, flap_tracks, std::vector<char>(o.incising->flaps.size(), 1));
        o.incising.reset();
    });
}

void check_blade(const Document& document, Id id, const NamedIncision& incision)
{
    if (incision.blade == 0) return;
    const Object& blade = object(document, incision.blade); // throws where there is none
    if (depending_on(document, {id}).contains(incision.blade))
        throw Rejected(named(incision.blade, blade) + " cannot open an incision of " +
                       named(document, id) + ", on which it depends");
}

// Drops or renumbers flaps; now(number) is 0 where an incision is gone.
void renumber_flaps(Object& o, const auto& now)
{
    std::vector<PeeledFlap>& flaps = o.incising->flaps;
    std::vector<char> gone(flaps.size(), 0);
    for (std::size_t k = 0; k < flaps.size(); ++k) {
        flaps[k].first = now(flaps[k].first);
        flaps[k].second = now(flaps[k].second);
        gone[k] = flaps[k].first == 0 || flaps[k].second == 0;
        flaps[k] = in_order(flaps[k]);
    }
    o.tracks = without_entries(o.tracks, flap_tracks, gone);
    std::size_t k = 0;
    std::erase_if(flaps, [&](const PeeledFlap&) { return gone[k++] != 0; });
}

IncisionSide other_side(IncisionSide side)
{
    return side == IncisionSide::left ? IncisionSide::right : IncisionSide::left;
}

} // namespace

const Incising& incising_of(const Document& document, Id id)
{
    const Object& own = object(document, id);
    if (!own.incising) throw Rejected(named(id, own) + " has no incisions");
    return *own.incising;
}

std::size_t incision_index(const Document& document, Id id, int number)
{
    return entry_index(document, id, incising_of(document, id).cuts.size(), number, "incisions");
}

void check(const NamedIncision& incision)
{
    const std::vector<SurfacePoint>& stroke = incision.cut.stroke;
    if (stroke.size() < 2)
        throw Rejected(fmt::format("field \"stroke\" has {}; an incision goes through two at least",
                                   stroke.empty() ? "no points" : "one point"));
    if (stroke.size() > most_incision_points)
        throw Rejected(fmt::format("field \"stroke\" has {} points but at most {} are taken",
                                   with_commas(stroke.size()), with_commas(most_incision_points)));
    for (const SurfacePoint& each : stroke)
        if (const double length = glm::length(each.normal); !(std::abs(length - 1) < 0.01))
            throw Rejected(
                fmt::format("field \"normal\" has the length {} but must have the length 1",
                            number_text(length)));
    check_profile("depth_profile", incision.cut.depth_profile);
    check_profile("opening_profile", incision.cut.opening_profile);
}

void check(const Incising& incising)
{
    if (incising.cuts.size() > most_incisions)
        throw Rejected(fmt::format("field \"cuts\" has {} entries but at most {} are taken",
                                   incising.cuts.size(), most_incisions));
    if (incising.layers.size() > most_incision_layers)
        throw Rejected(fmt::format("field \"layers\" has {} entries but at most {} are taken",
                                   incising.layers.size(), most_incision_layers));
    for (std::size_t i = 0; i + 2 < incising.layers.size(); ++i)
        if (incising.layers[i + 1].depth < incising.layers[i].depth)
            throw Rejected("field \"layers\": each layer must go deeper than the one before");
    for (const NamedIncision& each : incising.cuts) check(each);
    if (incising.flaps.size() > most_peeled_flaps)
        throw Rejected(fmt::format("field \"flaps\" has {} entries but at most {} are taken",
                                   incising.flaps.size(), most_peeled_flaps));
    for (const PeeledFlap& each : incising.flaps)
        if (each.first < 1 || each.first >= each.second ||
            static_cast<std::size_t>(each.second) > incising.cuts.size())
            throw Rejected(fmt::format("field \"flaps\" names incisions {} and {}; a flap lies "
                                       "between two of the {}, the lower number first",
                                       each.first, each.second, incising.cuts.size()));
}

Document applied(Document document, const Incise& command)
{
    check(command.incision);
    const Object& own = object(document, command.object);
    check_has_surface(document, command.object, "incise");
    if (own.incising && own.incising->cuts.size() >= most_incisions)
        throw Rejected(fmt::format("{} has {} incisions already; at most {} are taken",
                                   named(command.object, own), own.incising->cuts.size(),
                                   most_incisions));
    check_blade(document, command.object, command.incision);
    check(Incising{.cuts = {}, .layers = command.layers});
    return with_changed(std::move(document), command.object, [&](Object& o) {
        if (!o.incising) o.incising = Incising{.cuts = {}, .layers = command.layers};
        o.incising->cuts.push_back(command.incision);
    });
}

StepTitle title(const Incise& c, const StepDocuments& step)
{
    return {"Incise " + names_in(step.before, {c.object}), {}};
}

Document applied(Document document, const EditIncision& command)
{
    const std::size_t index = incision_index(document, command.object, command.number);
    NamedIncision changed = command.incision;
    if (changed.cut.stroke.empty())
        changed.cut.stroke = incising_of(document, command.object).cuts[index].cut.stroke;
    check(changed);
    check_blade(document, command.object, changed);
    return with_changed(std::move(document), command.object, [&](Object& o) {
        // The left of a stroke is the right of its reverse.
        if (changed.cut.stroke != o.incising->cuts[index].cut.stroke &&
            changed.cut.stroke == reversed(o.incising->cuts[index]).cut.stroke)
            for (PeeledFlap& each : o.incising->flaps) {
                if (each.first == command.number)
                    each.side_of_first = other_side(each.side_of_first);
                if (each.second == command.number)
                    each.side_of_second = other_side(each.side_of_second);
            }
        o.incising->cuts[index] = std::move(changed);
    });
}

StepTitle title(const EditIncision& c, const StepDocuments& step)
{
    const std::size_t index = incision_index(step.before, c.object, c.number);
    const NamedIncision& before = incising_of(step.before, c.object).cuts[index];
    const std::string of = called(before, c.number) + " of " + names_in(step.before, {c.object});
    return title_of_changes(changes(before, incising_of(step.after, c.object).cuts[index]),
                            "Change " + of, of);
}

Document applied(Document document, const LayerIncisions& command)
{
    for (const Id id : distinct(document, command.objects)) incising_of(document, id);
    Incising layers = command.incising;
    layers.cuts.clear();
    layers.flaps.clear();
    check(layers);
    return with_all_changed(std::move(document), command.objects, [&](Object& o) {
        o.incising->layers = layers.layers;
        o.incising->rows = layers.rows;
    });
}

StepTitle title(const LayerIncisions& c, const StepDocuments& step)
{
    return {"Layers in the incisions of " + names_in(step.before, c.objects), {}};
}

Document applied(Document document, const SwapIncisions& command)
{
    const std::size_t a = incision_index(document, command.object, command.first),
                      b = incision_index(document, command.object, command.second);
    if (a == b) throw Rejected("fields \"first\" and \"second\" must name two different incisions");
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::swap(o.incising->cuts[a], o.incising->cuts[b]);
        o.tracks = with_swapped_entries(o.tracks, incision_tracks, a, b);
        renumber_flaps(o, [&](int number) {
            return number == command.first    ? command.second
                   : number == command.second ? command.first
                                              : number;
        });
    });
}

StepTitle title(const SwapIncisions& c, const StepDocuments& step)
{
    const auto name = [&](int number) {
        return called(
            incising_of(step.before, c.object).cuts[incision_index(step.before, c.object, number)],
            number);
    };
    return {fmt::format("Swap {} and {} of {}", name(c.first), name(c.second),
                        names_in(step.before, {c.object})),
            {}};
}

Document applied(Document document, const RemoveIncision& command)
{
    const std::size_t index = incision_index(document, command.object, command.number);
    const std::size_t count = incising_of(document, command.object).cuts.size();
    if (count == 1) return without_incisions(std::move(document), command.object);
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<char> gone(count, 0);
        gone[index] = 1;
        o.tracks = without_entries(o.tracks, incision_tracks, gone);
        renumber_flaps(o, [&](int number) {
            return number == command.number ? 0 : number - (number > command.number);
        });
        o.incising->cuts.erase(o.incising->cuts.begin() + static_cast<long>(index));
    });
}

StepTitle title(const RemoveIncision& c, const StepDocuments& step)
{
    const std::size_t index = incision_index(step.before, c.object, c.number);
    return {fmt::format("Remove {} of {}",
                        called(incising_of(step.before, c.object).cuts[index], c.number),
                        names_in(step.before, {c.object})),
            {}};
}

Document applied(Document document, const ClearIncisions& command)
{
    for (const Id id : distinct(document, command.objects))
        document = without_incisions(std::move(document), id);
    return document;
}

} // namespace trivar
