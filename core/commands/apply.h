// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <set>

namespace trivar {

// What each command does, its numbers already checked. Throws Rejected and nothing happened.
Document applied(Document document, const ImportModel& command);
Document applied(Document document, const EditImport& command);
Document applied(Document document, const Relink& command);
Document applied(Document document, const AddPlane& command);
Document applied(Document document, const AddBox& command);
Document applied(Document document, const AddSphere& command);
Document applied(Document document, const AddCylinder& command);
Document applied(Document document, const AddTorus& command);
Document applied(Document document, const AddMoebius& command);
Document applied(Document document, const AddTeapot& command);
Document applied(Document document, const AddText& command);
Document applied(Document document, const SetText& command);
Document applied(Document document, const SetTransform& command);
Document applied(Document document, const Arrange& command);
Document applied(Document document, const SetMaterial& command);
Document applied(Document document, const ClearMaterial& command);
Document applied(Document document, const Rename& command);
Document applied(Document document, const Hide& command);
Document applied(Document document, const Show& command);
Document applied(Document document, const Lock& command);
Document applied(Document document, const Unlock& command);
Document applied(Document document, const Delete& command);
Document applied(Document document, const Duplicate& command);
Document applied(Document document, const Group& command);
Document applied(Document document, const Ungroup& command);
Document applied(Document document, const Reorder& command);
Document applied(Document document, const Place& command);
Document applied(Document document, const PlaceRound& command);
Document applied(Document document, const EditPlacement& command);
Document applied(Document document, const Unplace& command);
Document applied(Document document, const SaveCamera& command);
Document applied(Document document, const DeleteCamera& command);
Document applied(Document document, const SetRender& command);
Document applied(Document document, const SetTime& command);
Document applied(Document document, const SetTravel& command);
Document applied(Document document, const PlayClip& command);
Document applied(Document document, const Animate& command);
Document applied(Document document, const Refine& command);
Document applied(Document document, const ClearRefine& command);
Document applied(Document document, const PressVolume& command);
Document applied(Document document, const MovePoints& command);
Document applied(Document document, const InsertKnots& command);
Document applied(Document document, const CoarsenVolume& command);
Document applied(Document document, const MendVolume& command);
Document applied(Document document, const AllowFolds& command);
Document applied(Document document, const Unshape& command);
Document applied(Document document, const WarpVolume& command);
Document applied(Document document, const Paste& command);
Document applied(Document document, const AddLattice& command);
Document applied(Document document, const SetLattice& command);

// The ids of a list. Throws Rejected if it is empty, an object does not exist or is named twice.
std::set<Id> distinct(const Document& document, const std::vector<Id>& ids);

// The document with one object replaced by change(copy of it).
Document with_changed(Document document, Id id, auto&& change)
{
    Object changed = object(document, id);
    change(changed);
    document.objects.set(id, make_ref(std::move(changed)));
    return document;
}
// The same for each of a list; Rejected if it is empty or names one twice.
Document with_all_changed(Document document, const std::vector<Id>& ids, auto&& change)
{
    for (const Id id : distinct(document, ids))
        document = with_changed(std::move(document), id, change);
    return document;
}

// Throws Rejected where the object lies on no stroke.
void check_placed(const Object& object, Id id);
// Throws Rejected where the object neither lies on a stroke nor is a lattice.
void check_has_volume(const Object& object, Id id);
// Throws Rejected for control points that no lattice can have.
void check_lattice(const LatticeShape& shape);
// The document with `holder` as the parent of those objects, which stay where they stand.
Document with_parent_of(Document document, const std::vector<Id>& objects, Object holder);
// Throws Rejected for what no step of shaping can be, whatever the volume.
void check(const VolumeEdit& edit);
void check(const Refining& refining);
// Of the shaping of one object. A hand makes a few hundred; every one is done again when the stroke
// changes.
inline constexpr std::size_t most_shaping_steps = 4096;

// The document with one object more, under the next id.
Document with_added(Document document, Object object);

// Those and everything inside the groups among them.
std::set<Id> with_contents(const Document& document, std::set<Id> ids);

// Throws Rejected where groups nest too deep below it.
void check_depth(const Document& document, Id group);
void check_own_depth(const Document& document, Id id); // of that one alone

void check_transform(const Transform& transform);
// Rotation, scale and translation of an affine matrix; what shear it has is lost.
Transform decomposed(const glm::dmat4& matrix);

} // namespace trivar
