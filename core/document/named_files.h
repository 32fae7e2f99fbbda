// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// A NamedFile is a file from which an object is made, under the name that the scene gives it.
struct NamedFile {
    enum class Kind { model, font, image } kind = Kind::model;
    std::string path; // relative to the scene's folder (AssetStore::resolve)
};
// The files that an object names; empty: it is made from no file. A font that is named by its
// family and not by its file does not count.
std::vector<NamedFile> files_named(const Object& object);

} // namespace trivar
