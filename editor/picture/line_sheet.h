// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/document/document.h"
#include "core/drawing/drawing_sheet.h"
#include "core/evaluation/evaluated.h"

namespace trivar {

// The lines of a scene alone, as a camera sees them: a layer per level of volume data and per kind
// of line of each object that is drawn in lines. The sheet is black where the scene's look is, else
// white. Objects hide their own lines, and not those of others. 1 us per point, and see
// certified_silhouettes() and ObjectLines for what is found.
DrawingSheet line_sheet(const Evaluation& evaluated, const Document& document,
                        const Camera& camera);

} // namespace trivar
