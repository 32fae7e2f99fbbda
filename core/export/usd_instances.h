// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/export/rigid_tiles.h"
#include "core/files/growing_file.h"

#include <deque>

namespace trivar {

// A UsdPlace is where one instance is, in the precision of a PointInstancer: its rotation has half
// precision there.
struct UsdPlace {
    glm::vec3 position;
    glm::vec4 turn; // x y z w
    glm::vec3 scale;
    bool operator==(const UsdPlace&) const = default;
};
NodeTransform in_usd_precision(const NodeTransform& parts);

// A UsdInstancer is one mesh at many places through all moments of a film.
struct UsdInstancer {
    FilmStrip mesh;                            // the mesh alone, at all moments
    std::vector<std::vector<UsdPlace>> places; // by moment; empty where it is not shown
};

// An InstancedFilm is the strips of a film with tiles and copies as instances. Tiles that are
// further than the tolerance from an instance at some moment are strips of their own.
struct InstancedFilm {
    std::vector<FilmStrip> strips;
    std::vector<UsdInstancer> instancers;
    std::vector<RigidCount> counts; // one per layer
    std::deque<Part> parts;         // those that the strips show and the film has not
};
InstancedFilm instanced(const Film& film, double tolerance, const Progress& progress = {});

// Adds a PointInstancer below the scene but for its prototype, which is to be written after it with
// the same name, followed by "}".
void begin_instancer(GrowingFile& file, const Film& film, const UsdInstancer& of,
                     const std::string& name);

} // namespace trivar
