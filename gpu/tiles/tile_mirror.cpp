// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_mirror.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace trivar::gpu {
namespace {

constexpr std::uint8_t unseen = 255;

// How far a tile of a draft may be off by the bound of its stretch, in half pixels: that is about
// one pixel, for the bound is about twice what tiles are stretched by. Pictures that are no drafts
// show every tile as it is.
constexpr double half_pixels_off = 4;

bool has_tiles(const Instance& instance)
{
    return instance.tiles && !instance.tiles->tiles->empty() && instance.opacity > 0 &&
           instance.tiles->model->mesh->face_count() > 0;
}

// A square that reaches half a side beyond the unit square, on the floor.
Ref<Mesh> made_footprint()
{
    Mesh out = plane_mesh({2, 2}, {8, 8});
    for (glm::vec3& p : out.positions) p += glm::vec3(0.5f, 0.5f, 0);
    return make_ref(std::move(out));
}

// By level the numbers of the tiles that have it, ascending.
std::vector<std::vector<std::uint32_t>> by_level(const std::vector<std::uint8_t>& levels,
                                                 std::size_t count)
{
    std::vector<std::vector<std::uint32_t>> out(count);
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (levels[i] != unseen) out[levels[i]].push_back(static_cast<std::uint32_t>(i));
    return out;
}

double mean_size(const TileSet& set)
{
    double sum = 0;
    for (const TileSet::Extent& each : set.extents) sum += glm::length(each.hull.size());
    return sum / static_cast<double>(std::max<std::size_t>(set.extents.size(), 1));
}

} // namespace

bool TileMirror::any(const Picture& picture)
{
    return std::ranges::any_of(picture.instances, has_tiles);
}

void TileMirror::update(const Picture& picture, const Camera& camera, Mirror& mirror)
{
    of_instance_.assign(picture.instances.size(), nullptr);
    counts_ = {};
    ++pictures_;
    std::map<std::pair<int, PartKey>, int> met;
    std::set<Key> wanted;
    for (std::size_t i = 0; i < picture.instances.size(); ++i) {
        const Instance& instance = picture.instances[i];
        if (!has_tiles(instance)) continue;
        const Key key{instance.id, instance.part, met[{instance.id, instance.part}]++};
        Entry& entry = entries_[key];
        try {
            take(entry, instance.tiles);
        } catch (const Rejected&) { // its mesh is drawn
            continue;
        }
        wanted.insert(key);
        entry.picture = pictures_;
        const TileView view(camera, instance.to_world, picture.draft);
        const bool anew = entry.changes != entry.patches->changes();
        entry.changes = entry.patches->changes();
        entry.to_world = instance.to_world;
        if (anew || entry.view != view) choose_levels(entry, view);
        choose_casting(entry, view, mirror, anew);
        DrawnTiles& drawn = entry.drawn;
        // Tiles of strands and covers leave no gaps between them.
        const bool apart = instance.part.piece == 0;
        const std::size_t count = instance.highlighted && apart ? entry.set->tiles->size() : 0;
        if (static_cast<std::size_t>(drawn.footprints.upright) != count) {
            if (!footprint_) footprint_ = made_footprint();
            drawn.footprint = footprint_;
            Numbers all(count);
            std::iota(all.begin(), all.end(), 0u);
            drawn.footprints = uploaded(all);
            drawn.footprints.footprints = true;
        }
        drawn.footprints.patches = drawn.patches;
        of_instance_[i] = &drawn;
        counts_.tiles += entry.set->tiles->size();
        counts_.all_vertices += entry.set->vertex_count();
        for (const DrawnTiles::Level& level : drawn.levels) {
            counts_.drawn += level.chosen;
            counts_.vertices += level.chosen * level.mesh->vertex_count();
        }
    }
    std::erase_if(entries_, [&](const auto& item) { return !wanted.contains(item.first); });
}

void TileMirror::take(Entry& entry, const Ref<TileSet>& set)
{
    if (entry.set == set && entry.patches->tiles() == set->tiles) return;
    const bool other_model = !entry.set || entry.set->model != set->model;
    // Other meshes of the object stand on the same patches.
    const auto has_them = [&](const auto& item) {
        return item.second.patches && item.second.patches->tiles() == set->tiles;
    };
    if (const auto same = std::ranges::find_if(entries_, has_them); same != entries_.end()) {
        entry.patches = same->second.patches;
    } else {
        const bool kept = std::ranges::any_of(entries_, [&](const auto& item) {
            const Entry& other = item.second;
            return &other != &entry && other.picture == pictures_ && other.patches == entry.patches;
        });
        if (kept || !entry.patches) entry.patches = std::make_shared<TilePatches>();
        entry.patches->write(set->tiles, set->box);
    }
    entry.set = set;
    entry.view.reset();
    entry.changes = 0;
    DrawnTiles& drawn = entry.drawn;
    drawn.patches = entry.patches;
    drawn.size = mean_size(*set);
    if (!other_model) return;
    drawn.levels.clear();
    for (const TileLevel& level : *set->model->levels)
        drawn.levels.push_back({level.mesh, 0, {}, {}});
    entry.seen.assign(drawn.levels.size(), {});
    entry.casting.assign(drawn.levels.size(), {});
    entry.levels.clear();
}

void TileMirror::show(const DepthPyramid& before, const glm::dmat4& world_to_clip)
{
    counts_.drawn = counts_.vertices = 0;
    for (auto& [key, entry] : entries_) {
        const TileSet& set = *entry.set;
        const glm::dmat4 to_clip = world_to_clip * entry.to_world;
        std::vector<std::uint8_t> levels = entry.levels;
        parallel_blocks(levels.size(), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (levels[i] != unseen && before.hides(set.extents[i].hull, to_clip))
                    levels[i] = unseen;
        });
        std::vector<Numbers> seen = by_level(levels, entry.drawn.levels.size());
        for (std::size_t l = 0; l < seen.size(); ++l) {
            DrawnTiles::Level& level = entry.drawn.levels[l];
            rewrite(level.seen, entry.seen[l], seen[l]);
            level.seen.patches = entry.patches;
            counts_.drawn += seen[l].size();
            counts_.vertices += seen[l].size() * level.mesh->vertex_count();
        }
        entry.seen = std::move(seen);
    }
}

void TileMirror::choose_levels(Entry& entry, const TileView& view)
{
    const TileSet& set = *entry.set;
    const std::vector<TileLevel>& levels = *set.model->levels;
    entry.view = view;
    entry.levels.resize(set.tiles->size(), unseen);
    parallel_blocks(entry.levels.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const TileSet::Extent& extent = set.extents[i];
            std::uint8_t& level = entry.levels[i];
            if (!view.sees(extent.hull)) {
                level = unseen;
                continue;
            }
            const std::optional<std::size_t> last =
                level != unseen ? std::optional<std::size_t>(level) : std::nullopt;
            const double tolerance = half_pixels_off * view.tolerance(extent.hull);
            level = 0;
            if (view.steady())
                level =
                    static_cast<std::uint8_t>(level_for(levels, extent.stretch, tolerance, last));
        }
    });
    for (std::size_t l = 0; l < levels.size(); ++l)
        entry.drawn.levels[l].chosen = static_cast<std::size_t>(
            std::ranges::count(entry.levels, static_cast<std::uint8_t>(l)));
}

void TileMirror::choose_casting(Entry& entry, const TileView& view, Mirror& mirror, bool anew)
{
    const TileSet& set = *entry.set;
    // Two texels of a draft's shadow map over all of them, or about a pixel of a view that is
    // nearer. What was chosen stays while it is fine enough and not by far too fine, so that maps
    // are not drawn anew wherever the camera moves.
    const double coarse = glm::length(set.box.size()) / 512;
    const double most = std::clamp(half_pixels_off * view.tolerance(set.box), coarse / 64, coarse);
    const double last = entry.caster_tolerance;
    const double tolerance = !view.steady()                    ? 0
                             : last <= most && 3 * last > most ? last
                                                               : 0.8 * most;
    if (!anew && tolerance == entry.caster_tolerance) return;
    entry.caster_tolerance = tolerance;
    const std::vector<TileLevel>& levels = *set.model->levels;
    std::vector<std::uint8_t> chosen(set.tiles->size());
    parallel_blocks(chosen.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            chosen[i] =
                static_cast<std::uint8_t>(level_for(levels, set.extents[i].stretch, tolerance));
    });
    std::vector<Numbers> casting = by_level(chosen, levels.size());
    for (std::size_t l = 0; l < casting.size(); ++l) {
        MirroredCopies& drawn = entry.drawn.levels[l].casting;
        if (!anew && casting[l] == entry.casting[l]) continue;
        rewrite(drawn, entry.casting[l], casting[l]);
        drawn.patches = entry.patches;
        drawn.serial = mirror.next_serial();
    }
    entry.casting = std::move(casting);
}

std::size_t TileMirror::bytes() const
{
    std::set<const TilePatches*> known; // shared ones count once
    std::size_t sum = 0;
    for (const auto& [key, entry] : entries_)
        if (entry.patches && known.insert(entry.patches.get()).second)
            sum += entry.patches->bytes();
    return sum;
}

} // namespace trivar::gpu
