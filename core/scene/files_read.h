// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"

namespace trivar {

// Digest of all files that the objects' shapes come from, as they were when they were read: models
// with the buffers, materials and pictures that they name, and the fonts that were found. Empty:
// there are none. Reads what the store has not read yet. Throws Rejected where a model is missing.
std::string digest_of_files(const Document& document, const AssetStore& assets);

} // namespace trivar
