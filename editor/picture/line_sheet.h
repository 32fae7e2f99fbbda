// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/document/document.h"
#include "core/drawing/hand_edits.h"
#include "core/stages/evaluated.h"

namespace trivar {

// The lines of a scene alone, as a camera sees them: a layer per level of volume data and per kind
// of line of each object that is drawn in lines; pixels of the camera. The sheet is black where the
// scene's look is, else white. Objects hide their own lines, and not those of others. Costs what
// VolumeLines and ObjectLines do in their first view. Lines of volume data have the ids that they
// have in an .svg whose edits are given; those of meshes are known again in the same view alone.
DrawingSheet line_sheet(const Evaluation& evaluated, const Document& document, const Camera& camera,
                        const HandEdits& edits = {});

} // namespace trivar
