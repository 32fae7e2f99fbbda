// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/tile_pieces.h"

#include "core/base/parallel.h"

#include <map>

namespace trivar {
namespace {

constexpr unsigned crossed = ~0u; // the sides of a tile that a cut may go through

// Returns the tiles of a run on the wanted sides; the run itself if all are.
PlacedTiles::Run chosen(const PlacedTiles::Run& run, const unsigned* sides, unsigned wanted)
{
    std::vector<PlacedTile> out;
    for (std::size_t i = 0; i < run->size(); ++i)
        if (sides[i] == wanted) out.push_back((*run)[i]);
    return out.size() == run->size() ? run : make_ref(std::move(out));
}

} // namespace

TilePieces tile_pieces(const Ref<TileSet>& set, bool alone, const SidesOfBox& sides_of,
                       const std::function<bool(unsigned sides)>& kept)
{
    std::vector<unsigned> sides(set->tiles->size());
    parallel_blocks(sides.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            sides[i] = sides_of(set->extents[i].hull).value_or(crossed);
    });
    std::map<unsigned, PlacedTiles> of;
    for (const unsigned each : sides) of[each];
    TilePieces out;
    if (of.size() == 1 || !alone) {
        if (of.size() > 1 || of.contains(crossed))
            out.crossed = *set->mesh;
        else if (!of.empty() && kept(of.begin()->first))
            out.whole.emplace_back(of.begin()->first, set);
        return out;
    }
    for (auto& [wanted, tiles] : of) {
        if (wanted != crossed && !kept(wanted)) continue;
        for (std::size_t r = 0; r < set->tiles->runs().size(); ++r)
            tiles.add(
                chosen(set->tiles->runs()[r], sides.data() + set->tiles->begin_of(r), wanted));
        if (wanted == crossed)
            out.crossed = make_ref(bent_tiles(*set->model->mesh, tiles));
        else
            out.whole.emplace_back(wanted, tile_set(set->model, make_ref(std::move(tiles)), set));
    }
    return out;
}

} // namespace trivar
