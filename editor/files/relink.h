// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <vector>

namespace trivar {

// Imported models whose file is not where the scene looks for it.
std::vector<Id> missing_files(const Session& session);

// Takes a model from another file, as a job. What else is missing and lies in the same folder
// under its own name is taken from there as well, a step each.
void relink(Session& session, Id object, const std::string& path);

// Takes what the files of these models hold now for what is meant, as a job; the others are left.
void read_anew(Session& session, const std::vector<Id>& objects);

} // namespace trivar
