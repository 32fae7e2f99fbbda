// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/files/source_files.h"

namespace trivar {

// The digest of all files from which the objects' shapes come, as they were when they were read:
// models with the buffers, materials and pictures that they name, and the fonts that were found.
// Empty: there are none. Files that the store has not read yet are read now. Throws Rejected where
// a model is missing, unless missing models are allowed.
std::string digest_of_files(const Document& document, const AssetStore& assets,
                            bool missing_is_well = false);

// All existing files from which a scene is made: its log and the files kept beside it, the models
// with the files that they name, and the fonts that are named by their file. `or_else` as in
// SourceFiles.
SourceFiles source_files(const Document& document, const AssetStore& assets, const std::string& log,
                         std::string or_else = {});

} // namespace trivar
