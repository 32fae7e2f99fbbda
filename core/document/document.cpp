// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>

namespace trivar {

const Object& object(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    if (found == document.objects.end()) throw Rejected("there is no object " + std::to_string(id));
    return *found->second;
}

bool is_lattice(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found != document.objects.end() && kind_of(*found->second).has_cage;
}

std::string named(Id id, const Object& object)
{
    return "object " + std::to_string(id) + " (" + excerpt(object.name) + ")";
}

std::string named(const Document& document, Id id)
{
    return named(id, object(document, id));
}

std::vector<Id> lattices_round(const Document& document, Id id)
{
    std::vector<Id> out;
    for (Id up = object(document, id).parent; up != 0; up = object(document, up).parent)
        if (kind_of(document, up).bends_others) out.push_back(up);
    return out;
}

bool visible(const Document& document, Id id)
{
    for (; id != 0; id = object(document, id).parent)
        if (object(document, id).hidden) return false;
    return true;
}

bool locked(const Document& document, Id id)
{
    for (; id != 0; id = object(document, id).parent)
        if (object(document, id).locked) return true;
    return false;
}

std::vector<Id> in_row_order(const Document& document)
{
    std::vector<Id> ids, arranged(*document.rows);
    ids.reserve(document.objects.size());
    for (const Id id : arranged)
        if (document.objects.contains(id)) ids.push_back(id);
    std::sort(arranged.begin(), arranged.end());
    for (const auto& [id, ref] : document.objects)
        if (!std::binary_search(arranged.begin(), arranged.end(), id)) ids.push_back(id);
    return ids;
}

glm::dmat4 to_world(const Document& document, Id id)
{
    glm::dmat4 matrix(1);
    for (; id != 0; id = object(document, id).parent)
        matrix = object(document, id).transform.matrix() * matrix;
    return matrix;
}

} // namespace trivar
