// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

namespace trivar {

// The frames of a scene that are exported, both ends included.
struct FrameRange {
    int first = 1, last = 1;
    bool operator==(const FrameRange&) const = default;
};
// "A:B", or "A"; empty: all of the scene's. Throws Rejected where one is none of the scene's.
FrameRange frame_range(const std::string& text, const Time& time);

// One part of an object through all moments of a film, as long as it has the same triangles. Where
// they change in time, as a text's that grows, each kind of them is a piece of its own.
struct FilmStrip {
    Id object = 0;
    PartKey key = {};
    int number = 0; // of that key, among those of its object
    std::string name;
    int piece = 0;                  // of the part, in the order in which they come
    std::vector<const Part*> shown; // by moment; null: it is not shown then
    Ref<std::vector<Material>> materials;
    const Part& first() const; // that is shown
    bool bent() const;         // at some moment a volume deforms it
    bool posed() const;        // at some moment a pose moves its vertices
    bool reshaped() const;     // at some moment its vertices are others before all that, by keys
};
bool same_faces(const Mesh& a, const Mesh& b); // and as many vertices

// A scene at some moments, ascending, in frames; those between two frames, too. Meshes are not
// worked out. All of it is in memory: some 1 to 2 KB for each part that is another than at the
// moment before.
struct Film {
    std::vector<double> moments;
    std::vector<Evaluation> evaluated; // by moment
    std::vector<FilmStrip> strips;     // by object, key and piece
    std::size_t kept = 0;              // such parts, and the moments
};
inline constexpr std::size_t most_kept = 4'000'000; // of a film: several GB

// The choices of refined objects are left out: their triangles would differ from frame to frame.
Document unrefined(Document document);
// Of the unrefined document. Throws Rejected where more would be kept than may be, or the triangles
// of something change very often, and Cancelled.
Film film_of(const Document& document, const Ref<AssetStore>& assets, std::vector<double> moments,
             const Progress& progress = {});
// What the scene lacks at some moment, a sentence each (core/evaluation/lacking.h).
std::vector<std::string> lacks(const Film& film, const Document& document);
// The moments of a range, some to a frame.
std::vector<double> moments_of(const FrameRange& range, int per_frame);

// The mesh in the world, worked out anew and not kept.
Mesh mesh_in_world(const Part& part);

} // namespace trivar
