// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <optional>

namespace trivar {

// A Certificate says how close the flat triangles of an exported file are to the true surfaces.
struct Certificate {
    double tolerance = 0; // metres; 0: each object's own
    double bound = 0;     // the greatest of the parts
    double frame = 1;
    std::string log;    // the scene's file, without its folders
    int lines = 0;      // number of lines of the log that were applied; 0: all
    std::string scene;  // digest of the document
    std::string result; // digest of all deformed positions
    // Within which tiles were written as instances, metres; none: nothing was.
    std::optional<double> instances = {};
    struct PartClaim {
        Id object = 0;
        int part = 0; // of the object
        std::string name;
        int node = 0; // of the file
        std::size_t triangles_before = 0, triangles = 0, degenerate = 0, not_certified = 0;
        double tolerance = 0, bound = 0;
        std::string method, rule;
    };
    std::vector<PartClaim> parts; // those that lie in a volume
    // An UnlaidObject should lie in a volume and does not; nothing is claimed of it.
    struct UnlaidObject {
        Id object = 0;
        std::string name, why;
    };
    std::vector<UnlaidObject> not_laid;
};

std::string part_title(const Certificate::PartClaim& claim); // "Snake (part 1)"
std::string bound_text(double bound); // "0.00042 m", rounded up; or "no bound"
// One sentence per part that is not certified to be within its tolerance.
std::vector<std::string> not_certified(const Certificate& certificate);

// The JSON is {"trivar_certificate": {...}} and is stored in Model::extras. Reading it throws
// Rejected.
std::string to_json(const Certificate& certificate);
Certificate certificate_from_json(const std::string& text);

// A SampledPart is the result of sampling the triangles of a part of a file.
struct SampledPart {
    std::size_t samples = 0;
    double furthest = 0; // largest distance of the flat triangles from the true surface, metres
    // number that the part should have; where the file has another number, nothing is sampled
    std::size_t triangles = 0;
    bool other_triangles = false;
};
// Samples the triangles of a part of a file.
//   positions  of the file, world, metres
//   corners    three vertices per triangle, grouped by material as write_glb() groups them
//   steps      number of samples along an edge
SampledPart sampled(const Part& part, const std::vector<glm::vec3>& positions,
                    const std::vector<std::uint32_t>& corners, int steps);

} // namespace trivar
