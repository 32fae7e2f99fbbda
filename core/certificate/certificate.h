// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <optional>

namespace trivar {

// What an exported file says of how close its flat triangles are to the true surfaces.
struct Certificate {
    double tolerance = 0; // metres; 0: each object's own
    double bound = 0;     // the greatest of the parts
    double frame = 1;
    std::string log;    // the scene's file, without its folders
    int lines = 0;      // of it, the last that was applied; 0: all
    std::string scene;  // digest of the document
    std::string result; // digest of all deformed positions
    struct PartClaim {
        Id object = 0;
        int part = 0; // of the object
        std::string name;
        int node = 0; // of the file
        std::size_t triangles_before = 0, triangles = 0, degenerate = 0, not_certified = 0;
        double tolerance = 0, bound = 0;
        std::string method, rule;
    };
    std::vector<PartClaim> parts; // what lies in a volume
    struct NotLaid {              // what should lie in one, and of which nothing is claimed
        Id object = 0;
        std::string name, why;
    };
    std::vector<NotLaid> not_laid;
};

std::string part_title(const Certificate::PartClaim& claim); // "Snake (part 1)"
std::string bound_text(double bound); // "0.00042 m", rounded up; or "no bound"
// What is not certified to be within its tolerance, a sentence each.
std::vector<std::string> not_certified(const Certificate& certificate);

// {"trivar_certificate": {...}}, for Model::extras, and back. Throws Rejected.
std::string to_json(const Certificate& certificate);
Certificate certificate_from_json(const std::string& text);

// What a part of a file was found to be, by sampling its triangles.
struct SampledPart {
    std::size_t samples = 0;
    double furthest = 0;       // of the flat triangles from the true surface, metres
    std::size_t triangles = 0; // there should be; where there are others nothing is sampled
    bool other_triangles = false;
};
// `corners` are three a triangle, grouped by material as write_glb() does. `steps` along an edge.
SampledPart sampled(const Part& part, const std::vector<glm::vec3>& positions,
                    const std::vector<std::uint32_t>& corners, int steps);

} // namespace trivar
