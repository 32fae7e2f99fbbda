// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/named_files.h"
#include "editor/session/session.h"

#include <string>
#include <vector>

namespace trivar {

// Imported models, heights, volume data and layers with masks of which a file is not where the
// scene looks for it.
std::vector<Id> missing_files(const Session& session);

// The file of an object that another one would replace, where the scene looks for it; empty: none.
std::string file_to_relink(const Session& session, Id object);

// Returns the kind of file of an object that would be replaced: a missing one, if there is one.
FileKind kind_to_relink(const Session& session, Id object);

// Takes a model, a picture or volume data of an object from another file, as a job: of several the
// one that is missing. Other missing files that lie in the same folder under their own names are
// taken from there as well, one step each.
void relink(Session& session, Id object, const std::string& path);

// Whether any of the objects is read from a file.
bool reads_files(const Session& session, const std::vector<Id>& objects);
// Accepts the present content of the files of these objects, as a job; others are not touched.
void read_anew(Session& session, const std::vector<Id>& objects);

} // namespace trivar
