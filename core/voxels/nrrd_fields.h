// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The head of an NRRD file as text, in two parts: the lines for the library that reads them, and
// the names of the files with the data, which it would open itself.
struct NrrdFields {
    std::string text;                    // ends with an empty line
    std::vector<std::string> data_files; // as they are named; patterns are written out
    std::size_t size = 0;                // bytes of the head in the file
};

// Throws Rejected for a head of more than a million bytes and for a damaged list of files.
NrrdFields nrrd_fields(std::string_view bytes, const std::string& name);

// The names that a pattern of C's printf with one %d (%03d, ...) gives for numbers from `first` to
// `last`, as NRRD and MetaImage say many files. Throws Rejected for any other pattern, a step of 0
// and more than 100,000 names.
std::vector<std::string> numbered_names(const std::string& pattern, int first, int last, int step,
                                        const std::string& name);

} // namespace trivar
