// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/write_model.h"

namespace make {

// A coarse closed mesh of quads to be subdivided.
struct Cage {
    std::string name;
    Mesh mesh;
    std::vector<Crease> creases;
};
std::vector<Cage> cages();

void write_cages(const std::string& folder); // FOLDER/NAME.obj

} // namespace make
