// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <vector>

namespace trivar {

// Imported models whose file is not where the scene looks for it.
std::vector<Id> missing_files(const Session& session);

// Takes a model from another file, as a job. Other missing files that lie in the same folder under
// their own names are taken from there as well, one step each.
void relink(Session& session, Id object, const std::string& path);

// Accepts the present content of the files of these models, as a job; other models are not touched.
void read_anew(Session& session, const std::vector<Id>& objects);

} // namespace trivar
