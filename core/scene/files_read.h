// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/files/source_files.h"

namespace trivar {

// Digest of all files that the objects' shapes come from, as they were when they were read: models
// with the buffers, materials and pictures that they name, and the fonts that were found. Empty:
// there are none. Reads what the store has not read yet. Throws Rejected where a model is missing,
// unless that is well.
std::string digest_of_files(const Document& document, const AssetStore& assets,
                            bool missing_is_well = false);

// All files that a scene is made from, as far as they are there: its log and what is kept of it,
// the models with the files that they name, and the fonts that are named by their file. `or_else`
// as in SourceFiles.
SourceFiles source_files(const Document& document, const AssetStore& assets, const std::string& log,
                         std::string or_else = {});

} // namespace trivar
