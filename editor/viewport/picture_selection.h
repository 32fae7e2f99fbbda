// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/selection.h"
#include "gpu/picture.h"

namespace trivar {

// Leaves the instances and curves of these objects out of the picture; ascending ids.
void leave_out(gpu::Picture& picture, const std::vector<Id>& ids);

// Outlines the selection: instances and curves by their ids, and copies by theirs if the instance
// is not selected itself.
void outline_selected(gpu::Picture& picture, const Members& selected);

// Returns the outline with its width in a picture: thinner if all that is selected is thin.
gpu::Outline outline_for(const gpu::Picture& picture, gpu::Outline outline);

} // namespace trivar
