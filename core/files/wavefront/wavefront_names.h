// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/folder_files.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The names of files in OBJ and MTL stand unquoted behind options and may hold blanks, so what a
// line names depends on what is in the folder. Readers and companions_of both ask here.

// The material libraries of an OBJ's mtllib: one, whose name may hold blanks, or several.
struct NamedLibraries {
    std::vector<NamedFile> found;
    std::vector<std::string_view> missing; // as they are written
};
NamedLibraries libraries_named(std::string_view words, FolderFiles& files);

// Whether a keyword of an MTL is followed by the name of a picture.
bool names_picture(std::string_view keyword);

// A PictureLine is the text after a keyword that names a picture.
struct PictureLine {
    std::string name; // as it is written
    std::optional<NamedFile> file;
    double strength = 1;                 // -bm
    bool clamped = false;                // -clamp on
    std::vector<std::string> left_out{}; // options that would change the picture and are not read
};
PictureLine picture_line(std::string_view words, FolderFiles& files);

} // namespace trivar
