// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/drawing/hand_edits.h"
#include "core/scene_lines/line_drawer.h"

namespace trivar {

// The lines of a scene as layers of a sheet, called *object: level* or *object: kind of line*;
// `named` false: by the second alone. Layers without lines are left out of a named one.
std::vector<DrawingLayer> drawing_layers(const SceneLines& lines, bool named = true);

// A LineSheet is a sheet with the lines of a scene alone.
struct LineSheet {
    DrawingSheet sheet;
    AppliedEdits edits;               // how many of the given ones were applied
    std::vector<std::string> notices; // as SceneLines has them
};
// The lines as a camera sees them: a layer per level of volume data and per kind of line of each
// part that is drawn in lines; pixels of the camera. The sheet is black where the scene's look is,
// else white. Costs what LineDrawer does in its first view. The edits are done to it: lines of
// volume data have the ids that they have in the .svg whose edits are given; those of meshes are
// known again in the same view alone. Throws Cancelled.
LineSheet line_sheet(const Evaluation& evaluated, const Document& document, const Camera& camera,
                     const HandEdits& edits = {}, const Progress& progress = {});

// Reads the edits in an .svg that is about to be written anew: none of a path without one, or of
// one that was not drawn here. Throws Rejected for one that cannot be read, rather than lose what a
// person did to it.
HandEdits edits_to_keep(const std::string& path);

} // namespace trivar
