// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

#include <optional>

namespace trivar {

// Makes the document that is evaluated while a level is dragged: large volume data of which levels
// alone have another value than before are coarsened to at most 2^21 samples, so that a level is
// found in a frame or two. `evaluated` says how many samples there are. None: nothing is dragged,
// or it is small.
std::optional<Document> level_draft(const Document& before, const Document& now,
                                    const Evaluation& evaluated);

} // namespace trivar
