// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"
#include "editor/session/session.h"

namespace trivar {

// A PlainMeshWish asks for the shape that an object on a stroke has now as a model of its own.
struct PlainMeshWish {
    Id object = 0;
    Refining refining = {}; // its tolerance and its budget
    bool in_place = false;  // it takes the place of what lies there; else it is a new object
};

// A PlainMeshDialog is the dialog in which a person says how fine it is to be.
struct PlainMeshDialog {
    bool open = false;
    PlainMeshWish wish;
};

// The selected object where it lies on a stroke and has a shape of its own, and can so become a
// plain mesh; 0: none.
Id laid_shape(const Session& session);
// The wish for it, as it is refined already, or as by default.
PlainMeshWish usual_plain_mesh(const Session& session, bool in_place);

// Starts the job that splits the triangles, writes a .glb into the scene's folder for shapes, and
// then runs the one command: apply_shape in place, else import. A notice says what is certified, or
// why nothing was made. Where the scene was saved meanwhile the file is in its new folder.
void make_plain_mesh(Session& session, const PlainMeshWish& wish);

} // namespace trivar
