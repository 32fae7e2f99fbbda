// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/adjustment.h"

#include "core/commands/every_command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/tries.h"
#include "editor/hands/motion.h"

namespace trivar {
namespace {

template <class T> inline constexpr bool adds = false;
template <class Shape> inline constexpr bool adds<AddShape<Shape>> = true;

template <class T>
concept OnChosenObjects = std::is_same_v<T, SetMaterial> || std::is_same_v<T, ClearMaterial> ||
    std::is_same_v<T, Hide> || std::is_same_v<T, Show> || std::is_same_v<T, Lock> ||
    std::is_same_v<T, Unlock> || std::is_same_v<T, Delete> || std::is_same_v<T, Duplicate>;

struct AdjustedStep {
    Transform before, after;
};
Transform with_same_change(Transform t, const AdjustedStep& c)
{
    t.translation += c.after.translation - c.before.translation;
    t.rotation_deg += c.after.rotation_deg - c.before.rotation_deg;
    t.scale *= c.after.scale / c.before.scale;
    return t;
}

std::optional<Command> moved_alike(const Session& session, const AdjustedStep& change)
{
    std::vector<Id> ids;
    std::vector<Transform> transforms;
    for (const Stand& stand : stands_of(session.document(), session.selected.ids())) {
        ids.push_back(stand.id);
        transforms.push_back(with_same_change(stand.transform, change));
    }
    if (ids.empty()) return std::nullopt;
    return arranged(ids, transforms);
}

} // namespace

bool can_be_adjusted(const Command& command)
{
    return differ_in_numbers_only(command, command);
}

void follow_steps(Adjustment& a, const Session& session)
{
    const History& history = session.scene().history();
    const std::size_t now = history.position();
    if (a.running) return;
    const bool made = a.known && now == a.seen + 1 && now == history.steps().size() &&
                      !session.scene().look_only();
    if (made)
        a.step = can_be_adjusted(history.steps().back().command) ? now : 0;
    else if (now != a.step || now != history.steps().size())
        a.step = 0;
    a.seen = now;
    a.known = true;
}

void propose_instead(Adjustment& a, Session& session, const Command& command)
{
    if (session.committing()) return;
    if (!a.running) {
        a.running = true;
        a.selected = session.selected.ids();
        session.undo();
    }
    session.propose(command);
    session.selected.set(a.selected);
    session.selected.keep_those_in(session.document());
}

void finish_adjusting(Adjustment& a, Session& session, bool cancelled)
{
    if (!a.running) return;
    a.running = false;
    if (cancelled) session.cancel();
    const bool made = session.proposing() && session.commit();
    if (!made) session.redo();
    session.selected.set(a.selected);
    session.selected.keep_those_in(session.document());
    a.step = a.seen = session.scene().history().position();
}

std::optional<Command> repeated(const Session& session)
{
    const History& history = session.scene().history();
    const std::size_t now = history.position();
    if (now == 0) return std::nullopt;
    const Document& before = now == 1 ? history.start() : history.steps()[now - 2].result;
    const std::vector<Id> ids = topmost(session.document(), session.selected.ids());
    const auto again = [&]<class C>(const C& c) -> std::optional<Command> {
        if constexpr (adds<C>) {
            return c;
        } else if constexpr (OnChosenObjects<C>) {
            if (ids.empty()) return std::nullopt;
            C next = c;
            next.objects = ids;
            return next;
        } else if constexpr (std::is_same_v<C, SetTransform>) {
            return moved_alike(session, {object(before, c.object).transform, c.transform});
        } else if constexpr (std::is_same_v<C, Arrange>) {
            const Id first = c.objects.front();
            return moved_alike(session, {object(before, first).transform, c.transforms.front()});
        } else {
            return std::nullopt;
        }
    };
    return visit(again, history.steps()[now - 1].command);
}

} // namespace trivar
