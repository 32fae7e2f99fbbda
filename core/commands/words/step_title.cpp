// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/step_title.h"

#include <fmt/format.h>

namespace trivar {
namespace {

const Object* found_in(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? nullptr : &*found->second;
}

} // namespace

std::string StepDocuments::made() const
{
    return name_in(after, before.next_id);
}

const Object* StepDocuments::was(Id id) const
{
    return found_in(before, id);
}

const Object* StepDocuments::is(Id id) const
{
    return found_in(after, id);
}

std::string name_in(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? "object " + std::to_string(id) : found->second->name;
}

std::string names_in(const Document& document, const std::vector<Id>& ids)
{
    if (ids.size() == 1) return name_in(document, ids[0]);
    if (ids.size() == 2) return name_in(document, ids[0]) + " and " + name_in(document, ids[1]);
    return fmt::format("{} objects", ids.size());
}

} // namespace trivar
