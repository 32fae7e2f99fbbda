// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_mirror.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "gpu/context.h"

#include <algorithm>
#include <atomic>
#include <epoxy/gl.h>
#include <numeric>
#include <set>

namespace trivar::gpu {
namespace {

constexpr std::uint8_t unseen = 255;

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

// Returns the numbers of the tiles at each level, ascending.
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

TileMirror::TileMirror() : wants_card_(!is_software()) {}

void TileMirror::choose_on_card(bool on_card)
{
    wants_card_ = on_card;
}

// Its programs are made here, so that a driver that does not compile them leaves it to the
// processor.
bool TileMirror::can_choose_on_card(const Picture& picture, Programs& programs) const
{
    if (!wants_card_ || epoxy_gl_version() < 43) return false;
    for (const Instance& instance : picture.instances)
        if (has_tiles(instance) && !TileSieve::fits(instance.tiles->tiles->size())) return false;
    try {
        for (const ProgramName& name : TileSieve::programs()) programs.use(name);
        for (const ProgramName& name : pyramid_programs()) programs.use(name);
    } catch (const Rejected&) {
        return false;
    }
    return true;
}

bool TileMirror::any(const Picture& picture)
{
    return std::ranges::any_of(picture.instances, has_tiles);
}

void TileMirror::update(const Picture& picture, const Camera& camera, Mirror& mirror,
                        Programs& programs)
{
    of_instance_.assign(picture.instances.size(), nullptr);
    const TileCounts before = counts();
    const bool on_card = any(picture) && can_choose_on_card(picture, programs);
    if (std::exchange(on_card_, on_card) != on_card) entries_.clear();
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
            if (on_card && !entry.sieve) entry.sieve = std::make_unique<TileSieve>();
            if (on_card) entry.sieve->write(*entry.set, entry.patches->origin());
        } catch (const Rejected&) { // its mesh is drawn
            continue;
        }
        wanted.insert(key);
        entry.picture = pictures_;
        const TileRule rule = rule_of(camera, instance.to_world, entry.patches->origin(),
                                      picture.draft, *entry.set->model->levels);
        const bool anew = entry.changes != entry.patches->changes();
        const bool other = anew || entry.rule != rule;
        entry.changes = entry.patches->changes();
        entry.to_world = instance.to_world;
        entry.rule = rule;
        if (on_card)
            prepare_draws(entry, mirror, picture.settings.wire);
        else if (other)
            choose_levels(entry);
        choose_casting(entry, mirror, anew);
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
        // The card's counts are upper bounds until it has told them.
        for (std::size_t l = 0; l < (on_card ? 1 : drawn.levels.size()); ++l)
            counts_.add(l, drawn.levels[l].chosen, drawn.levels[l].mesh->vertex_count());
    }
    if (on_card && before.tiles == counts_.tiles) counts_ = before; // more likely than the most
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
    entry.rule.reset();
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
    if (entry.sieve) entry.sieve->forget_levels();
}

void TileMirror::show(const DepthPyramid& before, const glm::dmat4& world_to_clip)
{
    counts_ = {counts_.tiles, 0, 0, 0, counts_.all_vertices, {}};
    for (auto& [key, entry] : entries_) {
        const TileSet& set = *entry.set;
        const glm::dvec3& origin = entry.patches->origin();
        const TileRule rule =
            with_pyramid(*entry.rule, before.size_px(), world_to_clip, entry.to_world, origin);
        std::vector<std::uint8_t> levels = entry.levels;
        std::atomic<std::size_t> hidden = 0;
        parallel_blocks(levels.size(), 512, [&](std::size_t begin, std::size_t end) {
            TileChooser chooser{rule, before.depths()};
            std::size_t here = 0;
            for (std::size_t i = begin; i < end; ++i) {
                if (levels[i] == unseen) continue;
                const TileHull hull = hull_of(set.extents[i], origin);
                if (!chooser.hidden(hull.lo, hull.hi)) continue;
                levels[i] = unseen;
                ++here;
            }
            hidden += here;
        });
        counts_.hidden += hidden;
        std::vector<Numbers> seen = by_level(levels, entry.drawn.levels.size());
        for (std::size_t l = 0; l < seen.size(); ++l) {
            DrawnTiles::Level& level = entry.drawn.levels[l];
            rewrite(level.seen, entry.seen[l], seen[l]);
            level.seen.patches = entry.patches;
            counts_.add(l, seen[l].size(), level.mesh->vertex_count());
        }
        entry.seen = std::move(seen);
    }
}

void TileMirror::show(const DevicePyramid* before, const glm::dmat4& world_to_clip,
                      Programs& programs)
{
    std::vector<LateCounts::Layer> layers;
    for (const auto& [key, entry] : entries_) {
        LateCounts::Layer layer{entry.set->tiles->size(), entry.set->vertex_count(), {}};
        for (const DrawnTiles::Level& level : entry.drawn.levels)
            layer.vertices.push_back(level.mesh->vertex_count());
        layers.push_back(std::move(layer));
    }
    const Buffer& totals = late_counts_.next(std::move(layers));
    std::size_t first_total = 0;
    for (const auto& [key, entry] : entries_) {
        const TileRule rule = with_pyramid(*entry.rule, before ? before->size_px() : glm::ivec2(0),
                                           world_to_clip, entry.to_world, entry.patches->origin());
        entry.sieve->choose(programs, rule, before, totals, first_total);
        first_total += LateCounts::kinds;
    }
    late_counts_.asked();
}

const TileCounts& TileMirror::counts()
{
    if (const std::optional<TileCounts> told = on_card_ ? late_counts_.told() : std::nullopt)
        counts_ = *told;
    return counts_;
}

void TileMirror::choose_levels(Entry& entry)
{
    const TileSet& set = *entry.set;
    entry.levels.resize(set.tiles->size(), unseen);
    parallel_blocks(entry.levels.size(), 512, [&](std::size_t begin, std::size_t end) {
        TileChooser chooser{*entry.rule};
        for (std::size_t i = begin; i < end; ++i) {
            const TileHull hull = hull_of(set.extents[i], entry.patches->origin());
            std::uint8_t& level = entry.levels[i];
            const int last = level == unseen ? chooser.UNSEEN : level;
            const int next = chooser.chosen_level(hull.lo, hull.hi, hull.stretch, last);
            level = next == chooser.UNSEEN ? unseen : static_cast<std::uint8_t>(next);
        }
    });
    for (std::size_t l = 0; l < entry.drawn.levels.size(); ++l)
        entry.drawn.levels[l].chosen = static_cast<std::size_t>(
            std::ranges::count(entry.levels, static_cast<std::uint8_t>(l)));
}

void TileMirror::prepare_draws(Entry& entry, Mirror& mirror, bool edges)
{
    std::vector<TileSieve::Command> commands;
    const auto draw = [&](std::size_t level, int count, int first) {
        TileSieve::Command& command = commands.emplace_back();
        command.count = static_cast<std::uint32_t>(count);
        command.first = static_cast<std::uint32_t>(first);
        command.level = static_cast<std::uint32_t>(level);
    };
    for (std::size_t l = 0; l < entry.drawn.levels.size(); ++l) {
        DrawnTiles::Level& level = entry.drawn.levels[l];
        level.chosen = l == 0 || entry.rule->steady ? entry.set->tiles->size() : 0;
        level.seen.upright = static_cast<int>(level.chosen);
        level.seen.patches = entry.patches;
        level.seen.chosen = entry.sieve->rows();
        level.seen.level = l;
        level.seen.first_command = commands.size();
        for (const MirroredMesh::Part& part : mirror.mesh(level.mesh).parts())
            draw(l, part.count, part.first);
        draw(l, edges ? mirror.edges(level.mesh, level.mesh).indices->count : 0, 0);
    }
    entry.sieve->take(std::move(commands));
}

void TileMirror::choose_casting(Entry& entry, Mirror& mirror, bool anew)
{
    const TileSet& set = *entry.set;
    TileChooser chooser{*entry.rule};
    const TileHull whole = hull_of({set.box, 0}, entry.patches->origin());
    // Two texels of a draft's shadow map over all of them, or about a pixel of a view that is
    // nearer. What was chosen stays while it is fine enough and not by far too fine, so that maps
    // are not drawn anew wherever the camera moves.
    const double coarse = glm::length(set.box.size()) / 512;
    const double most =
        std::clamp<double>(chooser.tolerance_for(whole.lo, whole.hi), coarse / 64, coarse);
    const double last = entry.caster_tolerance;
    const double tolerance = !entry.rule->steady               ? 0
                             : last <= most && 3 * last > most ? last
                                                               : 0.8 * most;
    if (!anew && tolerance == entry.caster_tolerance) return;
    entry.caster_tolerance = tolerance;
    const std::vector<TileLevel>& levels = *set.model->levels;
    std::vector<std::uint8_t> chosen(set.tiles->size());
    parallel_blocks(chosen.size(), 512, [&](std::size_t begin, std::size_t end) {
        TileChooser here{*entry.rule};
        for (std::size_t i = begin; i < end; ++i)
            chosen[i] = static_cast<std::uint8_t>(here.coarsest_within(
                static_cast<float>(set.extents[i].stretch), static_cast<float>(tolerance)));
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
