// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <set>

namespace trivar {

// The ids of a list as a set. Throws Rejected if the list is empty, an object does not exist or is
// named twice.
std::set<Id> distinct(const Document& document, const std::vector<Id>& ids);

// The document with one object replaced by change(copy of it).
Document with_changed(Document document, Id id, auto&& change)
{
    Object changed = object(document, id);
    change(changed);
    document.objects.set(id, make_ref(std::move(changed)));
    return document;
}
// The document with each listed object replaced. Throws Rejected if the list is empty or names an
// object twice.
Document with_all_changed(Document document, const std::vector<Id>& ids, auto&& change)
{
    for (const Id id : distinct(document, ids))
        document = with_changed(std::move(document), id, change);
    return document;
}

// Throws Rejected for another kind of object than the help of a command's field says: "id of a
// text".
[[noreturn]] void refuse_other_kind(const Document& document, Id id, std::string_view help);
// Throws Rejected where the object lies on no stroke.
void check_placed(const Object& object, Id id);
// Throws Rejected where the object neither lies on a stroke nor stands in a lattice.
void check_bent(const Document& document, Id id);
// Throws Rejected where the object neither lies on a stroke nor is a lattice.
void check_has_volume(const Object& object, Id id);
// Throws Rejected where the object has no surface; `verb` says what to do with those in it.
void check_has_surface(const Document& document, Id id, std::string_view verb);
// The tiling of a layer of tiles. Throws Rejected where the object is none.
const Tiling& tiling_of(const Document& document, Id id);

// The index of an entry of an object's list by its number, which counts from 1. `entries` is its
// word in the plural. Throws Rejected where the list has `count` entries and none of that number.
std::size_t entry_index(const Document& document, Id id, std::size_t count, int number,
                        std::string_view entries);

// The document with one more object, under the next id.
Document with_added(Document document, Object object);

// The given objects and everything inside the groups among them.
std::set<Id> with_contents(const Document& document, std::set<Id> ids);

// The given objects and all that depend on them: what lies on them, directly or on others that do,
// and what stands in a lattice that does.
std::set<Id> depending_on(const Document& document, const std::set<Id>& ids);

void check_transform(const Transform& transform);
// Rotation, scale and translation of an affine matrix; its shear is lost.
Transform decomposed(const glm::dmat4& matrix);

} // namespace trivar
