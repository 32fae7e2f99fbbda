// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walking/low_vertices.h"

#include <limits>

namespace trivar {

// A Foot is a part of a model that touches the ground for a while and is carried back under the
// model meanwhile.
struct Foot {
    std::vector<ModelVertex> sole; // its lowest vertices, 32 at most
    int node = 0; // the node that moves most of the sole: its joint, or where the mesh hangs
    double begin = 0, end = 0; // of its stance, in periods: 0 <= begin < 1, end < begin + 1
    // The correction that makes the foot stand and leave the ground clear, in the model's units: at
    // even steps through the period from `begin` on, with straight lines between.
    std::vector<glm::dvec3> shift;
    std::vector<int> leg; // nodes from the hip down to `node`
};

// A Gait says how a model walks on the spot in a clip. It is read off the vertices and needs no
// information on the rig.
struct Gait {
    double begin_s = 0, period_s = 0;         // of the clip
    glm::dvec3 up{0, 0, 1}, forward{1, 0, 0}; // unit, in the model's space
    double stride = 0;                        // way per period, in the model's units
    std::vector<Foot> feet;                   // in the order of their lowest vertices
    // the end of a sentence that says why there is no stride; empty: there is one
    std::string trouble;
};

// The clip is taken for one period. Vertices within a twentieth of the model's height over the
// ground are followed through 96 poses. The ground is what most of them move with while they are
// low, and those that move alike and lie together are a foot. `floor` is the height, along `up`,
// below which nothing is seen; feet that sink below it stand on it. Any number of threads gives the
// same bits. O(96 #V) of arithmetic.
Gait gait_of(const Model& model, const Clip& clip, const glm::dvec3& up = {0, 0, 1},
             double floor = -std::numeric_limits<double>::infinity());

// The moments at which gait_of looks, in the time of the clip.
std::vector<double> moments_of(const Clip& clip);

} // namespace trivar
