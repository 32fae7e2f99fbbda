// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/selection.h"

#include <algorithm>

namespace trivar {

Selection& Selection::operator=(Id id)
{
    ids_.clear();
    if (id != 0) ids_.push_back(id);
    return *this;
}

std::vector<Id> Selection::but_the_active() const
{
    return {ids_.begin(), ids_.empty() ? ids_.end() : ids_.end() - 1};
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

Members::Members(const Document& document, const std::vector<Id>& ids)
    : document_(&document),
      ids_(ids)
{
    std::sort(ids_.begin(), ids_.end());
}

bool Members::contain(Id id) const
{
    while (id != 0) {
        if (std::binary_search(ids_.begin(), ids_.end(), id)) return true;
        const auto found = document_->objects.find(id);
        id = found == document_->objects.end() ? 0 : found->second->parent;
    }
    return false;
}

std::vector<Id> topmost(const Document& document, const std::vector<Id>& ids)
{
    const Members members(document, ids);
    std::vector<Id> result;
    for (const Id id : ids) {
        const auto found = document.objects.find(id);
        if (found != document.objects.end() && !members.contain(found->second->parent))
            result.push_back(id);
    }
    return result;
}

} // namespace trivar
