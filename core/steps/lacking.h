// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/stages/evaluated.h"

namespace trivar {

// Whether no vertex is out of range where its part lies (core/mesh/extent.h).
bool is_within_reach(const Stage& stage);
// Removes parts whose vertices would be, and adds a notice. Deforms nothing.
void leave_out_what_is_out_of_reach(Stage& stage);

// One sentence "NAME: WHY" per thing that the evaluated objects lack: models and fonts named by
// their file that could not be read, and models that are too large. By id.
std::vector<std::string> lacks(const Evaluation& evaluated, const Document& document);

// IncompleteScene reports that a scene is not whole, with such sentences.
struct IncompleteScene : Rejected {
    explicit IncompleteScene(std::vector<std::string> all);
    std::vector<std::string> sentences;
};
// Throws IncompleteScene unless the list is empty.
void check_whole(std::vector<std::string> lacks);

} // namespace trivar
