// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/loft.h"

namespace make {

// A Steed holds the differences between a horse and a camel.
struct Steed {
    std::vector<Station> trunk;
    std::vector<vec4> neck, fore, hind, tail, mane; // limbs: xyz and radius
    vec3 poll, muzzle;                              // the head's axis
    float head, neck_flatness, fore_hoof, hind_hoof;
    vec3 coat, dark, light;
    bool camel;
};
Model quadruped(const Steed& steed);

// A skin for the root's mesh of a horse and the clip "walk": four beats, and its back goes with
// them. The limbs of the side z > 0, as they are in the mesh.
void walk(Model& model, const Limb& fore, const Limb& hind);

} // namespace make
