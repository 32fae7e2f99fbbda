// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

inline constexpr double most_tolerance = 1000; // metres; what is further off is not the scene

// What an animated file says of how close it is to the scene, at every time from its first frame to
// its last: distances in metres between what it shows and the true surface, point by point.
struct FilmCertificate {
    double tolerance = 0, bound = 0; // bound: the greatest of the parts, each as is_proven() says
    int first_frame = 1, last_frame = 1;
    double frames_per_second = 24;
    std::string log = {};   // the scene's file, without its folders
    std::string scene = {}; // digest of the document
    struct PartClaim {
        Id object = 0;
        int part = 0; // of the object
        std::string name = {};
        int node = 0;         // of the file, where its mesh hangs
        std::string way = {}; // still, node, skin or targets; still is what nothing moves
        int keys = 0;         // of its transform, or its joints together; or morph targets and 1
        int moments = 1;      // to a frame, at which it is compared
        std::size_t triangles_before = 0, triangles = 0;
        double space = 0;          // of its triangles, at every moment
        double motion = 0;         // from one moment to the next; 0 where that is not proven
        double bound = 0;          // of all together: at every time if proven, else at every moment
        std::string unproven = {}; // why it is known at the moments alone; empty: it is proven
    };
    std::vector<PartClaim> parts = {};
};

// Whether its bound holds at every time, not at the moments alone.
bool is_proven(const FilmCertificate::PartClaim& claim);
// Said after a bound: nothing where it holds at every time, else " at 4 moments to a frame".
std::string when_claimed(bool proven, int moments);

// What is not certified to be within the tolerance, a sentence each.
std::vector<std::string> not_certified(const FilmCertificate& certificate);
std::string part_title(const FilmCertificate::PartClaim& claim); // "Ants (part 3)"

// {"trivar_animation": {...}}, for Model::extras, and back. Throws Rejected.
std::string to_json(const FilmCertificate& certificate);
FilmCertificate film_certificate_from_json(const std::string& text);
bool has_film_certificate(const std::string& extras);

} // namespace trivar
