// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/evaluation/evaluated.h"

namespace trivar {

// Parts whose vertices would be out of reach where they lie (core/mesh/extent.h) go, and it is
// said. Deforms nothing.
void leave_out_what_is_out_of_reach(Stage& stage);

// What the evaluated objects lack, "NAME: WHY" each: models and fonts named by their file that
// could not be read, and what is too large to be worked with. By id.
std::vector<std::string> lacks(const Evaluation& evaluated, const Document& document);

// That a scene is not whole, by such sentences.
struct IncompleteScene : Rejected {
    explicit IncompleteScene(std::vector<std::string> all);
    std::vector<std::string> sentences;
};
// Throws IncompleteScene where there are any.
void check_whole(std::vector<std::string> lacks);

} // namespace trivar
