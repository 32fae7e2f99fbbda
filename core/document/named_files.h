// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/document/rule.h"

#include <string>
#include <vector>

namespace trivar {

// A FileUse is a file from which an object is made, under the name that the scene gives it.
struct FileUse {
    FileKind kind = FileKind::model;
    std::string path, hash; // relative to the scene's folder (AssetStore::resolve); as of its field
    int mask = 0; // of an image: number of the mask of tiles that reads it, from 1; 0: heights do
    VolumeReading reading = {}; // of volume data
};
// The files that an object names; empty: it is made from no file. A font that is named by its
// family and not by its file does not count.
std::vector<FileUse> files_named(const Object& object);

// Whether what a field of that kind holds is the path of a file: a font may be named by its family.
bool is_file_path(FileKind kind, const std::string& path);

// How volume data are read that a value names; what does not say it: as they are.
template <class Owner> VolumeReading reading_of(const Owner& owner)
{
    if constexpr (requires { owner.reading; })
        return owner.reading;
    else
        return {};
}

// The files that volume data are read from, absolute; the one that is named is the first unless it
// is a folder. Reads the data where they are not in memory. Empty: they are missing.
std::vector<std::string> files_of_volume(const FileUse& volume, const AssetStore& assets);

} // namespace trivar
