// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// metres; a shape that is further off is not the scene
inline constexpr double most_tolerance = 1000;

// A FilmCertificate says how close an animated file is to the scene at every time from its first
// frame to its last. Its numbers are distances in metres between the file's surface and the true
// one, point by point.
struct FilmCertificate {
    // bound: the greatest one of the parts; is_proven() tells when a part's bound holds
    double tolerance = 0, bound = 0;
    int first_frame = 1, last_frame = 1;
    double frames_per_second = 24;
    std::string log = {};   // the scene's file, without its folders
    std::string scene = {}; // digest of the document
    struct PartClaim {
        Id object = 0;
        int part = 0; // of the object
        std::string name = {};
        int node = 0;         // of the file, the one that holds the mesh
        std::string way = {}; // still (nothing moves), node, skin or targets
        int keys = 0;    // of its transform or of all its joints; or number of morph targets + 1
        int moments = 1; // number per frame at which the part is compared
        std::size_t triangles_before = 0, triangles = 0;
        double space = 0;  // error of its triangles, at every moment
        double motion = 0; // error from one moment to the next; 0 where it is not proven
        double bound = 0;  // total error: at every time if proven, else at every moment
        // why only the moments are known; empty: the bound is proven for every time
        std::string unproven = {};
    };
    std::vector<PartClaim> parts = {};
};

// Whether the claimed bound holds at every time, and not only at the moments.
bool is_proven(const FilmCertificate::PartClaim& claim);
// The words that follow a bound: empty where it holds at every time, else " at 4 moments to a
// frame".
std::string when_claimed(bool proven, int moments);

// One sentence per part that is not certified to be within the tolerance.
std::vector<std::string> not_certified(const FilmCertificate& certificate);
std::string part_title(const FilmCertificate::PartClaim& claim); // "Ants (part 3)"

// The JSON is {"trivar_animation": {...}} and is stored in Model::extras. Reading it throws
// Rejected.
std::string to_json(const FilmCertificate& certificate);
FilmCertificate film_certificate_from_json(const std::string& text);
bool has_film_certificate(const std::string& extras);

} // namespace trivar
