// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/volumes/phantom.h"

#include <cstdint>

// Volume data that the generator makes, in place of scans and computations of others.
namespace make {

struct Volume {
    glm::ivec3 size;
    float step_mm;
    std::vector<std::int16_t> samples; // x fastest
};

struct NamedVolume {
    std::string name; // of the file, without its ending
    std::function<Volume()> build;
};
std::vector<NamedVolume> volumes();

Volume rounded(const Phantom& phantom); // sampled

// NRRD, raw, 16 bits, little endian. Throws std::runtime_error when the file cannot be written.
void write_nrrd(const Volume& volume, const std::string& path);

Phantom jaw();     // a mandible with its teeth, in air; x to the left, y to the back, z up
Phantom foot();    // a left foot from the toes to the ankle, with its skin
Phantom neck();    // from C3 to C7: skin, muscles, vessels, trachea and spine
Phantom knee();    // femur, tibia, fibula, patella and cartilage
Volume protein();  // electrons of a folded chain, a thousandth per cubic Angstrom
Volume silicon();  // the valence electrons of 2 x 2 x 2 cells
Volume caffeine(); // the electrons of a molecule

} // namespace make
