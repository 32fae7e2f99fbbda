// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/last_shaping.h"

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

std::string amount_words(double metres)
{
    return ui::short_number(std::abs(metres)) + " m";
}

void tell_where_it_stopped(Session& session, const Shaping& step, const std::string& what,
                           const std::string& remedy)
{
    session.notices.say(ui::NoticeKind::warning, "The volume would fold here",
                        what + " stopped at " + amount_words(step.done) + ". " + remedy +
                            ", or turn the fold guard off.",
                        of_a_step);
}

} // namespace trivar
