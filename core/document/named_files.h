// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"

#include <string>
#include <vector>

namespace trivar {

// A NamedFile is a file from which an object is made, under the name that the scene gives it.
struct NamedFile {
    enum class Kind { model, font, image, volume } kind = Kind::model;
    std::string path; // relative to the scene's folder (AssetStore::resolve)
};
// The files that an object names; empty: it is made from no file. A font that is named by its
// family and not by its file does not count.
std::vector<NamedFile> files_named(const Object& object);

// The files that volume data are read from, absolute; the one that is named is the first unless it
// is a folder. Reads the data where they are not in memory. Empty: they are missing.
std::vector<std::string> files_of_volume(const VoxelShape& shape, const AssetStore& assets);

// A UsedPicture is a picture of numbers that an object uses, as the scene names it.
struct UsedPicture {
    int mask = 0; // number of the mask of its tiles, the first is 1; 0: its heights
    std::string path, hash;
};
std::vector<UsedPicture> pictures_of(const Object& object);

} // namespace trivar
