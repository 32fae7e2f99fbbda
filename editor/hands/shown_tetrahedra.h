// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/tetrahedra_shaper.h"
#include "editor/session/session.h"

namespace trivar {

// The volume of tetrahedra of an object as it was evaluated, and as it is said; null: it has none.
const EvaluatedObject* shown_tetrahedra(const Session& session, Id id);
const TetrahedraShape* tetrahedra_shape(const Document& document, Id id);

// The one volume that is selected alone, as it was evaluated; null: there is none.
const EvaluatedObject* selected_tetrahedra(const Session& session);

// The volume that an object is, or the innermost one that it stands in; 0: none.
Id tetrahedra_holding(const Session& session, Id id);

// Returns the result of the last edit; null: there was none.
const TetrahedraOutcome* last_outcome(const Session& session, Id id);

// The turn of the volume's own axes in the world, and the length there of a metre in it.
glm::dmat3 axes_of(const EvaluatedObject& volume);
double length_of(const EvaluatedObject& volume);

} // namespace trivar
