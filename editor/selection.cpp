// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/selection.h"

#include <algorithm>

namespace trivar {

Selection& Selection::operator=(Id id)
{
    ids_.clear();
    if (id != 0) ids_.push_back(id);
    return *this;
}

bool Selection::contains(Id id) const
{
    return std::find(ids_.begin(), ids_.end(), id) != ids_.end();
}

void Selection::set(const std::vector<Id>& ids)
{
    ids_.clear();
    add(ids);
}

void Selection::add(const std::vector<Id>& ids)
{
    for (const Id id : ids) {
        if (id == 0) continue;
        std::erase(ids_, id);
        ids_.push_back(id);
    }
}

void Selection::toggle(Id id)
{
    if (std::erase(ids_, id) == 0 && id != 0) ids_.push_back(id);
}

void Selection::keep_those_in(const Document& document)
{
    std::erase_if(ids_, [&](Id id) { return !document.objects.contains(id); });
}

bool belongs_to_one_of(const Document& document, Id id, const std::vector<Id>& ids)
{
    for (; id != 0; id = object(document, id).parent)
        if (std::find(ids.begin(), ids.end(), id) != ids.end()) return true;
    return false;
}

std::vector<Id> topmost(const Document& document, const std::vector<Id>& ids)
{
    std::vector<Id> result;
    for (const Id id : ids)
        if (!belongs_to_one_of(document, object(document, id).parent, ids)) result.push_back(id);
    return result;
}

} // namespace trivar
