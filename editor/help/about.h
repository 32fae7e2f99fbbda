// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A Library is a library that this program contains.
struct Library {
    std::string name, version, licence;
};
std::vector<Library> libraries();
std::string program_version(); // "0.1"
std::string program_build();   // compiler and kind of build

// All of it as text, for a report; `graphics` is what draws.
std::string about_text(const std::string& graphics);

} // namespace trivar
