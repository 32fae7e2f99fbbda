// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/last_shaping.h"

#include "core/commands/objects/shape.h"
#include "editor/session/topics.h"
#include "ui/widgets.h"

#include <cmath>

namespace trivar {

const Shaping* last_shaping(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    if (found == session.evaluated().objects.end() || !found->second->shaped) return nullptr;
    const std::vector<Shaping>& steps = found->second->shaped->steps;
    return steps.empty() ? nullptr : &steps.back();
}

void allow_folds(Session& session, Id id, const std::vector<VolumePart>& parts)
{
    if (!parts.empty()) session.run(AllowFolds{id, {parts}});
}

std::vector<VolumePart> with_mirrored(const VolumePart& part, bool mirror)
{
    if (!mirror) return {part};
    VolumePart other = part;
    other.lo.y = 1 - part.hi.y;
    other.hi.y = 1 - part.lo.y;
    return {part, other};
}

std::string amount_words(double metres)
{
    return ui::short_number(std::abs(metres)) + " m";
}

void tell_where_it_stopped(Session& session, const Shaping& step, const std::string& what,
                           const std::string& remedy, Id id, const std::vector<VolumePart>& parts)
{
    std::vector<ui::Notices::Action> offers;
    if (!parts.empty())
        offers.push_back(
            {allow_folds_action, [&session, id, parts] { allow_folds(session, id, parts); }});
    session.notices.say(ui::NoticeKind::warning, "The volume would fold here",
                        what + " stopped at " + amount_words(step.done) + ". " + remedy +
                            ", or turn the fold guard off.",
                        of_a_step, offers);
}

} // namespace trivar
