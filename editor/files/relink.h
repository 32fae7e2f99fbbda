// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <string>
#include <vector>

namespace trivar {

// Imported models, heights and layers with masks of which a file is not where the scene looks for
// it.
std::vector<Id> missing_files(const Session& session);

// The file of an object that another one would replace, where the scene looks for it; empty: none.
std::string file_to_relink(const Session& session, Id object);

// Whether the file of an object that would be replaced is a picture of a mask or of heights, and
// not that of a model: one that is missing, if there is one.
bool relinks_picture(const Session& session, Id object);

// Takes a model or a picture of an object from another file, as a job: of several the one that is
// missing. Other missing files that lie in the same folder under their own names are taken from
// there as well, one step each.
void relink(Session& session, Id object, const std::string& path);

// Accepts the present content of the files of these objects, as a job; others are not touched.
void read_anew(Session& session, const std::vector<Id>& objects);

} // namespace trivar
