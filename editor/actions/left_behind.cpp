// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/left_behind.h"

#include "core/commands/bind.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/arrange.h"
#include "core/document/bases.h"
#include "core/document/fields/placement_fields.h"
#include "core/placement/attachment.h"
#include "core/steps/laying/attaching.h"
#include "editor/commands/clipboard.h"
#include "editor/editor.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// The effects of a deletion on objects that lie on a stroke, in the order in which they are told.
enum class Fate { with_the_rest, where_drawn, straight, anew };
constexpr std::array<std::array<const char*, 2>, 4> fates{{
    {" goes with the rest of what carried it.", " go with the rest of what carried them."},
    {" goes with nothing now and lies where it was drawn.",
     " go with nothing now and lie where they were drawn."},
    {" has nothing left to lie on and stands straight. Place it anew.",
     " have nothing left to lie on and stand straight. Place them anew."},
    {" now falls on what is below.", " now fall on what is below."},
}};

bool carried_object(const std::optional<PlacementStep>& step)
{
    return step && step->attach && carries(*step->attach);
}

bool lost_what_it_was_on(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    if (found == document.objects.end()) return false;
    const Object& o = *found->second;
    return (o.stroke && o.stroke->onto.empty()) || (o.tiles && o.tiles->base == 0);
}

// Whether the last of so many steps is in force, and nothing was done after it.
bool deletion_is_last(const Session& session, std::size_t step)
{
    const History& history = session.scene().history();
    return step > 0 && history.position() == step && history.steps()[step - 1].command.is<Delete>();
}

void say_too_late(Session& session)
{
    session.notices.say(ui::NoticeKind::warning, "Other steps were made since the deletion",
                        "Go back to before it in the history.", of_a_step);
}

void add_once(std::vector<Id>& list, Id id)
{
    if (std::ranges::find(list, id) == list.end()) list.push_back(id);
}

} // namespace

LeftBehind left_behind(const Document& before, const Document& after,
                       const std::function<bool(Id laid, Id on)>& lies_on)
{
    LeftBehind out;
    std::array<std::vector<Id>, fates.size()> laid;
    struct Loss {
        std::vector<Id> users, used;
    };
    std::map<std::string_view, Loss> lost; // in which way something was used
    for (const auto& [id, ref] : after.objects) {
        const auto found = before.objects.find(id);
        if (found == before.objects.end() || found->second == ref) continue;
        const std::optional<PlacementStep>& was = found->second->stroke;
        for (const auto& [base, words] : bases_of(*found->second)) {
            if (after.objects.contains(base)) continue;
            if (words != lies_on_words) {
                add_once(lost[words].users, id);
                add_once(lost[words].used, base);
            } else {
                const PlacementStep& is = *ref->stroke;
                const bool attached = carried_object(was), straight = is.onto.empty();
                const auto touches = [on = base](const AttachedHost& host) {
                    return host.object == on && host.touched;
                };
                if (attached ? std::ranges::none_of(was->attach->hosts, touches)
                             : !straight && !lies_on(id, base))
                    continue;
                const Fate fate = carried_object(is)                     ? Fate::with_the_rest
                                  : straight && !is.parameters.on_ground ? Fate::straight
                                  : attached                             ? Fate::where_drawn
                                                                         : Fate::anew;
                add_once(laid.at(static_cast<std::size_t>(fate)), id);
            }
            add_once(out.dependents, id);
            add_once(out.gone, base);
        }
    }
    for (std::size_t k = 0; k < laid.size(); ++k)
        if (!laid[k].empty())
            out.lines.push_back(said_of(after, laid[k]) + fates[k][laid[k].size() == 1 ? 0 : 1]);
    std::vector<Id> bent;
    for (const auto& [id, ref] : before.objects)
        if (!after.objects.contains(id) && is_lattice(before, ref->parent) &&
            !after.objects.contains(ref->parent))
            bent.push_back(id);
    if (!bent.empty()) out.lines.push_back(said_of(before, bent) + " went with the lattice.");
    for (const auto& [words, loss] : lost)
        out.lines.push_back(fmt::format("{} {} no longer {} {}.", said_of(after, loss.users),
                                        loss.users.size() == 1 ? "is" : "are", words,
                                        said_of(before, loss.used)));
    return out;
}

void delete_objects(Editor& editor, const std::vector<Id>& ids)
{
    Session& session = editor.session;
    const Document before = session.committed();
    const auto lies_on = [&, seen = session.evaluated()](Id laid, Id on) {
        const auto found = seen.objects.find(laid);
        const auto& step = object(before, laid).stroke;
        if (found == seen.objects.end() || !step) return false;
        const auto met = attachment_of(*found->second, stroke_now(*found->second, *step),
                                       step->parameters.skip_back_faces);
        return met && std::ranges::any_of(met->hosts, [&](const AttachedHost& host) {
                   return host.object == on && host.touched;
               });
    };
    if (!session.run(Delete{ids})) return;
    LeftBehind left = left_behind(before, session.committed(), lies_on);
    if (left.lines.empty()) return;
    const std::size_t step = session.scene().history().position();
    auto& choice = editor.memory.of<BindChoice>();
    choice = {std::move(left.dependents), std::move(left.gone), step};
    std::vector<ui::Notices::Action> remedies;
    remedies.push_back({"Undo", [&session, step] {
                            if (deletion_is_last(session, step)) return session.undo();
                            say_too_late(session);
                        }});
    if (!choice.dependents.empty())
        remedies.push_back({"Bind to...", [&choice] { choice.asked = true; }});
    session.notices.say_all(ui::NoticeKind::warning, "Deleted", left.lines, of_a_step,
                            std::move(remedies));
}

std::vector<Id> can_be_bound_to(const Editor& editor, const std::vector<Id>& dependents)
{
    const Document& document = editor.session.committed();
    std::set<Id> there;
    for (const Id id : dependents)
        if (document.objects.contains(id)) there.insert(id);
    const std::set<Id> above = depending_on(document, there);
    std::vector<Id> out;
    for (const Id id : in_row_order(document))
        if (!above.contains(id) && kind_of(document, id).has_surface) out.push_back(id);
    return out;
}

void bind_to(Editor& editor, const BindChoice& choice, Id to)
{
    Session& session = editor.session;
    if (!deletion_is_last(session, choice.step)) {
        std::vector<Id> ids = choice.dependents;
        std::erase_if(ids, [&](Id id) { return !lost_what_it_was_on(session.committed(), id); });
        if (!ids.empty())
            session.run(Bind{ids, {}, to});
        else
            say_too_late(session);
        return;
    }
    const Command deletion = session.scene().history().steps()[choice.step - 1].command;
    session.undo();
    if (session.run(Bind{choice.dependents, choice.gone, to}))
        session.run(deletion);
    else
        session.redo();
}

} // namespace trivar
