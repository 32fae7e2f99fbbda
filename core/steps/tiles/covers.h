// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/limit/chart_uvs.h"
#include "core/stages/tiled_base.h"
#include "core/steps/tiles/masking.h"
#include "core/steps/tiles/tile_kinds.h"
#include "core/tiles/tile_counts.h"

namespace trivar {

struct CoverLayout;

// A CoverInput is the input for tiles that cover a base.
struct CoverInput {
    const Tiling& tiling;
    const TileKinds& kinds; // of its tiles
    const TiledPieces& pieces;
    const FoundLimit& limit;
    const std::map<int, std::vector<Part>>& members; // of the base
    const BaseMasks& masks;
    Timings& timings;
};
struct CoverParts {
    std::vector<Part> parts; // in the world
    TileCounts counts;
    std::vector<std::string> notices; // why nothing is covered
    // The greatest height of its tiles as a share of that which is proven; 0: nobody asked.
    double of_limit = 0;
};

// Covers lays tiles all over a base: over its limit surface where it is shown as a subdivision
// surface, and else over the faces of its meshes. The cells are laid out on the base at rest, and
// again only when its shape or the pattern changes. Tiles that one patch carries are a TileSet,
// whose mesh nevertheless fits its neighbours to the last bit; the others are a mesh.
class Covers {
public:
    CoverParts operator()(const CoverInput& input);

private:
    using Uvs = std::optional<ChartUvs>;
    struct LayoutInput {
        TiledPieces pieces;
        Ref<LimitBase> limit; // null: over the faces
        TileCover cover;      // pattern, size and tiles per face alone
        glm::dvec2 size;
        bool operator==(const LayoutInput&) const = default;
    };
    struct UvsInput {
        TiledPieces pieces;
        Ref<CoverLayout> layout;
        bool operator==(const UvsInput&) const = default;
    };
    struct MaskInput {
        Ref<CoverLayout> layout;
        BaseMasks masks;
        bool operator==(const MaskInput&) const = default;
    };
    struct CoverModel {
        Ref<Mesh> mesh; // with the materials of the layer
        Ref<TileModel> tile;
    };
    struct CoverMasks {
        std::vector<MaskFactors> tiles; // #tiles; empty: 1
        std::vector<double> heights;    // factors of the nodes; empty: 1
    };
    struct Plan;
    struct Standing;
    static Plan cells_of(const CoverInput& input);
    static std::vector<std::size_t> choose_kinds(Plan& plan);
    static Standing standing(const Plan& plan, const std::vector<Part>& parts);
    Ref<CoverLayout> layout(const CoverInput& input, const glm::dvec2& size);
    void find_uvs(Plan& plan, std::vector<std::string>& notices);
    Ref<CoverMasks> masks(const CoverInput& input, const Ref<CoverLayout>& layout);
    void add_member(const Plan& plan, int member, const std::vector<Part>& parts, CoverParts& out);
    void add_kind(const Plan& plan, Standing& there, std::size_t kind, int member, CoverParts& out);

    Kept<LayoutInput, Ref<CoverLayout>> layouts_;
    Kept<UvsInput, Ref<Uvs>> uvs_;
    Kept<MaskInput, Ref<CoverMasks>> masks_;
    Kept<UnitTile, CoverModel> models_{64};
};

// The advice for the user where tiles have too many vertices to be drawn.
inline constexpr const char* too_heavy_tiles_words =
    "simplify the object that the tiles are copies of, or lay fewer or larger ones";

// The fault of a base that is to be covered by texture coordinates, or displaced.
inline constexpr const char* lacks_uvs_words = "has no UVs";

// A sentence for so many tiles of each kind that they cannot be shown; else empty.
std::string too_many_words(const std::vector<TileKind>& kinds, std::span<const std::size_t> counts);

} // namespace trivar
