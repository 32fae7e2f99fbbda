// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

namespace trivar {

// A FrameRange holds the frames of a scene that are exported, both ends included.
struct FrameRange {
    int first = 1, last = 1;
    bool operator==(const FrameRange&) const = default;
};
// Reads "A:B" or "A"; an empty text means all frames of the scene. Throws Rejected where a frame is
// outside the scene's.
FrameRange frame_range(const std::string& text, const Time& time);

// A FilmStrip is one part of an object through all moments of a film, as long as the part keeps the
// same triangles. Where the triangles change in time, as those of a growing text do, there is one
// strip per kind of triangles.
struct FilmStrip {
    Id object = 0;
    PartKey key = {};
    int number = 0; // of this key among the parts of the object
    std::string name;
    int piece = 0;                  // among the strips of the part, in the order of time
    std::vector<const Part*> shown; // by moment; null: the part is not shown at that moment
    Ref<std::vector<Material>> materials;
    const Part& first() const; // the part at the first moment that shows it
    bool bent() const;         // whether a volume deforms the part at some moment
    bool posed() const;        // whether a pose moves its vertices at some moment
    bool reshaped() const; // whether keys change its vertices before volume and pose at some moment
};
bool same_faces(const Mesh& a, const Mesh& b); // also true only for equal numbers of vertices

// A Film is a scene at ascending moments, in frames, which may lie between two frames. Patterns
// that fill bodies are colours of vertices (core/evaluation/pattern_colors.h). Other meshes are not
// worked out. The whole film is in memory: 1 to 2 KB per part that differs from the moment
// before.
struct Film {
    std::vector<double> moments;
    std::vector<Evaluation> evaluated; // by moment
    std::vector<FilmStrip> strips;     // by object, key and piece
    std::size_t kept = 0;              // number of such parts, and of moments
};
inline constexpr std::size_t most_kept = 4'000'000; // the same number, at most: several GB

// The document without the refinement of objects, whose triangles would differ from frame to frame.
Document unrefined(Document document);
// The document must be unrefined. Throws Rejected where the film would keep more than `most_kept`,
// or where the triangles of an object change very often; throws Cancelled.
Film film_of(const Document& document, const Ref<AssetStore>& assets, std::vector<double> moments,
             const Progress& progress = {});
// One sentence per thing that the scene lacks at some moment (core/steps/lacking.h).
std::vector<std::string> lacks(const Film& film, const Document& document);
// The moments of a range, `per_frame` to each frame.
std::vector<double> moments_of(const FrameRange& range, int per_frame);

// The part's mesh in world space, worked out anew at each call and not kept.
Mesh mesh_in_world(const Part& part);

} // namespace trivar
