// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/common_mesh.h"

namespace trivar {

// A part as a mesh at its first moment, with a morph target for every key after that.
struct TargetKeys {
    Mesh mesh;                     // in the world
    std::vector<std::size_t> keys; // moments
    // How far its vertices are, as the file has them, from where they should be; by moment.
    std::vector<double> off;
    Channel weights; // of the targets, without a node; no times where there are none
};

// Keys so that no vertex is further off at a moment than is allowed there, with what single
// precision makes of times. Places at all moments are in memory meanwhile: 24 bytes a vertex and
// moment.
TargetKeys target_keys(const Film& film, const FilmStrip& strip, const CommonMesh& common,
                       const std::vector<double>& allowed, const std::vector<float>& times_s);

} // namespace trivar
