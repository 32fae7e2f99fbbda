// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// A file that an object is made from, by the name that the scene has for it.
struct NamedFile {
    enum class Kind { model, font } kind = Kind::model;
    std::string path; // as from the scene's folder (AssetStore::resolve)
};
// The files that an object names; empty: it is made from none. A font that is named by its family
// and not by its file is none.
std::vector<NamedFile> files_named(const Object& object);

} // namespace trivar
