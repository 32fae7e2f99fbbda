// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/pose.h"

namespace trivar {

// What touches the ground for a while and is carried back under the model meanwhile.
struct Foot {
    struct Point { // a vertex of the mesh that hangs on a node
        int node = 0;
        std::uint32_t vertex = 0;
    };
    std::vector<Point> sole;   // its lowest vertices, 32 at most
    int node = 0;              // that moves most of them: their joint, or where the mesh hangs
    double begin = 0, end = 0; // its stance, in periods: 0 <= begin < 1, end < begin + 1
    // The centre of the sole goes with the ground where it is `middle` - t stride forward, t being
    // the periods since the middle of the stance; only what lies along the ground counts.
    glm::dvec3 middle{0};
    glm::dvec3 first{0}, last{0}; // what it lacks to be there as its stance begins and ends
    std::vector<int> leg;         // nodes from the hip down to `node`
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
// lowest are followed through 96 poses; the ground is what most of them go with while they are low,
// and those that move alike and lie together are a foot. Bit for bit the same for any number of
// threads. O(96 #V) of arithmetic.
Gait gait_of(const Model& model, const Clip& clip, const glm::dvec3& up = {0, 0, 1});

// Where the middle of a foot's sole is, in the model's space.
glm::dvec3 sole_at(const Model& model, const Foot& foot, const Stance& stance);

} // namespace trivar
