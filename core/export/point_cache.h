// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/files/source_files.h"

namespace trivar {

// The places of an object's points in every frame, beside an OBJ of the first one whose vertices
// stand in the same order; both Y up. What is not shown stays where it was seen last.
enum class CacheFormat {
    pc2, // Kaldera's: a header of 32 bytes, little-endian
    mdd, // LightWave's: counts, times in seconds, places; big-endian
};

// FOLDER/NAME.OBJECT.pc2 and .obj for every object of the film, which has one moment a frame. Every
// file is whole or not there, and none takes the place of one of the sources. Returns the names of
// the caches. Throws Rejected and Cancelled.
std::vector<std::string> write_caches(const Film& film, CacheFormat format,
                                      double frames_per_second, const std::string& path,
                                      const Progress& progress = {},
                                      const SourceFiles& sources = {});

} // namespace trivar
