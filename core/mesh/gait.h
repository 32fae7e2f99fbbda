// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/low_vertices.h"

#include <limits>

namespace trivar {

// What touches the ground for a while and is carried back under the model meanwhile.
struct Foot {
    std::vector<ModelVertex> sole; // its lowest vertices, 32 at most
    int node = 0;                  // that moves most of them: their joint, or where the mesh hangs
    double begin = 0, end = 0;     // its stance, in periods: 0 <= begin < 1, end < begin + 1
    // What is added to it so that it stands and leaves the ground clear, in the model's units: at
    // even steps through the period from its begin on, with straight lines between.
    std::vector<glm::dvec3> shift;
    std::vector<int> leg; // nodes from the hip down to `node`
};

// How a model goes on the spot in a clip: read off its vertices, with no word about the rig.
struct Gait {
    double begin_s = 0, period_s = 0;         // of the clip
    glm::dvec3 up{0, 0, 1}, forward{1, 0, 0}; // unit, in the model's space
    double stride = 0;                        // how far a period carries it, in the model's units
    std::vector<Foot> feet;                   // in the order of their lowest vertices
    std::string trouble; // why there is no stride: a sentence's end; empty: there is one
};

// The clip is taken for one period. Vertices within a twentieth of the model's height over the
// ground are followed through 96 poses; the ground is what most of them go with while they are low,
// and those that move alike and lie together are a foot. `floor`: the height, along `up`, below
// which nothing is seen; feet that sink below it stand on it. Bit for bit the same for any number
// of threads. O(96 #V) of arithmetic.
Gait gait_of(const Model& model, const Clip& clip, const glm::dvec3& up = {0, 0, 1},
             double floor = -std::numeric_limits<double>::infinity());

// The moments that gait_of looks at, in the time of the clip.
std::vector<double> moments_of(const Clip& clip);

} // namespace trivar
