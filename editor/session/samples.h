// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A scene that comes with the program.
struct Sample {
    std::string path, title, words; // words: what it shows; may be empty
};

// Those of the files that are offered, the ones that show most first.
std::vector<Sample> samples_among(const std::vector<std::string>& paths);

// What a sample or a tutorial is called, by its file; empty: it is none that has a title of its
// own.
std::string sample_title(const std::string& path);

} // namespace trivar
