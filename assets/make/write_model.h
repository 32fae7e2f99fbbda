// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

// glTF 2.0 binary: triangles (a quad is cut along its shorter diagonal), one primitive a node and
// material, clips as animations. Throws std::runtime_error when the file cannot be written.
void write_glb(const Model& model, const std::string& path);

struct Crease { // between two point indices; 0 smooth, 10 and more infinitely sharp
    int a, b;
    float sharpness;
};

// Quads as they are, each with its texture coordinates; creases as OpenSubdiv's "t crease" lines.
void write_obj(const Mesh& mesh, const std::string& path, const std::vector<Crease>& creases = {});

} // namespace make
