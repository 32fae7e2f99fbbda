// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A Sample is a scene that comes with the program.
struct Sample {
    std::string path, title, words; // words: what it shows; may be empty
};

// The samples among the files, the ones that show most first.
std::vector<Sample> samples_among(const std::vector<std::string>& paths);

// The title of a sample or a tutorial, by its file; empty: it has no title of its own.
std::string sample_title(const std::string& path);

} // namespace trivar
