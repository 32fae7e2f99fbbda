// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace trivar {

// Places are the folders that come with the program.
struct Places {
    std::string scenes, tutorials, manual, pictures; // pictures: of the scenes, by their names
    std::string models;                              // in a checkout those that the build makes
};

// Returns the places where `cmake --install` puts them beside the program's own folder, else those
// of the checkout in which it was built; empty if there is neither.
Places places_of(const std::filesystem::path& program);

} // namespace trivar
