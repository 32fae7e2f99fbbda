// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/unwrap/unwrap.h"

#include <string>

namespace trivar::testing {

struct NamedMesh {
    std::string name;
    Mesh mesh;
};

// A ball, a torus, a box, a Moebius band, a bumpy ball, rough ground, two boxes that share an edge
// and two that touch in a point.
std::vector<NamedMesh> surfaces_to_unwrap();

Mesh bumpy_ball(int segments, double height);

Unwrapped unwrapped_alone(const Mesh& mesh, const UnwrapOptions& options = {});

} // namespace trivar::testing
