// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/files/source_files.h"

namespace trivar {

// A point cache holds the places of an object's points in every frame, beside an OBJ of the first
// frame with its vertices in the same order; both Y up. An object that is not shown stays where it
// was seen last.
enum class CacheFormat {
    pc2, // Kaldera's: a header of 32 bytes, little-endian
    mdd, // LightWave's: counts, times in seconds, places; big-endian
};

// Writes FOLDER/NAME.OBJECT.pc2 and .obj for every object of the film, which must have one moment
// per frame. Every file is written completely or not at all, and none replaces one of the sources.
// Returns the names of the caches. Throws Rejected and Cancelled.
std::vector<std::string> write_caches(const Film& film, CacheFormat format,
                                      double frames_per_second, const std::string& path,
                                      const Progress& progress = {},
                                      const SourceFiles& sources = {});

} // namespace trivar
