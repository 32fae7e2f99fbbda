// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/edits/edits.h"
#include "core/commands/words/step_title.h"
#include "core/document/field.h"

namespace trivar {

// A command that does the same with each of some objects and takes nothing else. `Of` has its verb,
// its summary, the help of its objects, its title with {} for their names, and change(object),
// unless applied() is written for the command itself.
template <class Of> struct OnObjects {
    static constexpr std::string_view verb = Of::verb, summary = Of::summary;
    static constexpr CommandNature nature = nature_of_type<Of>();
    std::vector<Id> objects;
    bool operator==(const OnObjects&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, Of::help, required.names_object());
    }
};
template <class Of> Document applied(Document document, const OnObjects<Of>& command)
{
    return with_all_changed(std::move(document), command.objects, Of::change);
}
template <class Of> StepTitle title(const OnObjects<Of>& c, const StepDocuments& step)
{
    std::string words(Of::title);
    return {words.replace(words.find("{}"), 2, names_in(step.before, c.objects)), {}};
}

} // namespace trivar
