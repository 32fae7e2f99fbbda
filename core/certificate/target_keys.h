// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/common_mesh.h"

namespace trivar {

// TargetKeys is a part as a mesh at its first moment, with one morph target per later key.
struct TargetKeys {
    Mesh mesh;                     // in the world
    std::vector<std::size_t> keys; // moments
    // The largest distance, in metres, of a vertex in the file from its place in the scene, at each
    // moment.
    std::vector<double> off;
    // The channel that weights the targets, without a node. Its times are empty if there are no
    // targets.
    Channel weights;
};

// Chooses keys so that at no moment a vertex is further off than `allowed` there; the rounding of
// times to single precision is counted. Memory meanwhile: 24 bytes per vertex and moment.
TargetKeys target_keys(const Film& film, const FilmStrip& strip, const CommonMesh& common,
                       const std::vector<double>& allowed, const std::vector<float>& times_s);

} // namespace trivar
