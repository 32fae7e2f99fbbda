// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/mirror.h"
#include "gpu/picture.h"
#include "gpu/tiles/late_counts.h"
#include "gpu/tiles/tile_patches.h"
#include "gpu/tiles/tile_sieve.h"

#include <tuple>

namespace trivar::gpu {

// DrawnTiles are the tiles of an instance as they are drawn: each that is seen by one level of its
// model, and each by one that casts its shadow.
struct DrawnTiles {
    struct Level {
        Ref<Mesh> mesh;
        // Number of tiles in view that are drawn so if nothing hides them; the most that there can
        // be where the graphics card chooses.
        std::size_t chosen = 0;
        MirroredCopies seen, casting;
    };
    std::vector<Level> levels;
    std::shared_ptr<const TilePatches> patches;
    // The ground of the tiles and round them, which closes the gaps in the outline of a layer;
    // empty where it has none.
    Ref<Mesh> footprint;
    MirroredCopies footprints;
    double size = 0; // of a tile, in the instance's units
};

// A TileMirror keeps the tiles of pictures on the GPU, by the id and part of their instances. Only
// what changed is uploaded: patches that differ, and, where the processor chooses, the numbers of
// tiles whose level is another. Processor and graphics card choose the same tiles.
class TileMirror {
public:
    TileMirror(); // who chooses: the card, unless it is software or has no OpenGL 4.3
    void choose_on_card(bool on_card);
    bool on_card() const { return on_card_; } // in the last update

    // Chooses how the picture's tiles are drawn, as a camera sees them, or prepares that.
    void update(const Picture& picture, const Camera& camera, Mirror& mirror, Programs& programs);
    // Limits the shown tiles to those that nothing in `before` hides: among those that the
    // processor has chosen, or else, on the card, among those that it chooses now; null: nothing
    // hides any. Draws of the picture's tiles must come after it.
    void show(const DepthPyramid& before, const glm::dmat4& world_to_clip);
    void show(const DevicePyramid* before, const glm::dmat4& world_to_clip, Programs& programs);
    // Returns the tiles of an instance, by its index in that picture; null: it has none, or they do
    // not fit into the device and are drawn as one mesh.
    const DrawnTiles* of(std::size_t instance) const { return of_instance_.at(instance); }
    // Returns the counts of the last update, or of an earlier one if the card is not done yet.
    const TileCounts& counts();
    std::size_t bytes() const; // memory of all patches
    static bool any(const Picture& picture);

private:
    using Numbers = std::vector<std::uint32_t>;
    struct Entry {
        Ref<TileSet> set;
        std::uint64_t changes = 0; // of the patches
        std::uint64_t picture = 0; // number of the last picture that showed it
        std::shared_ptr<TilePatches> patches;
        std::optional<TileRule> rule;     // by which the levels were chosen
        std::unique_ptr<TileSieve> sieve; // null: the processor chooses
        double caster_tolerance = 0;
        std::vector<std::uint8_t> levels;   // by tile; as they were when it was last seen
        std::vector<Numbers> seen, casting; // by level, as they are uploaded
        glm::dmat4 to_world{1};
        DrawnTiles drawn;
    };
    // The key is id and part, and the number of instances before this one that have the same.
    using Key = std::tuple<int, PartKey, int>;
    void take(Entry& entry, const Ref<TileSet>& set);
    bool can_choose_on_card(const Picture& picture, Programs& programs) const;
    static void choose_levels(Entry& entry);
    static void prepare_draws(Entry& entry, Mirror& mirror, bool edges); // by the card
    void choose_casting(Entry& entry, Mirror& mirror, bool anew);
    std::map<Key, Entry> entries_;
    std::vector<const DrawnTiles*> of_instance_;
    std::uint64_t pictures_ = 0; // number of updates
    bool wants_card_ = false, on_card_ = false;
    LateCounts late_counts_;
    Ref<Mesh> footprint_;
    TileCounts counts_;
};

} // namespace trivar::gpu
