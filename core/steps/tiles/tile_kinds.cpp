// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/tile_kinds.h"

#include "core/base/number_text.h"
#include "core/mesh/mesh_materials.h"
#include "core/mesh/morphed.h"
#include "core/stages/shapes.h"
#include "core/stages/standing.h"
#include "core/tiles/tile_mix.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <set>

namespace trivar {
namespace {

glm::dmat4 turned(const Object& object)
{
    return glm::dmat4(glm::dmat3(object.transform.matrix()));
}

const std::vector<Part>& own_parts(const Stage& stage)
{
    return stage.own_parts.empty() ? stage.parts : stage.own_parts;
}

// The clip that an object plays; null: none of its file.
const Clip* clip_of(const Shape& shape, const Playing& playing)
{
    const auto clip = std::ranges::find(shape.model->clips, playing.clip, &Clip::name);
    return clip != shape.model->clips.end() ? &*clip : nullptr;
}

bool morph_is_masked(const Tiling& tiling)
{
    return std::ranges::any_of(tiling.masks, [](const TileMask& mask) {
        return !mask.hidden && mask.drives == MaskDrives::morph;
    });
}

bool can_become(const std::vector<Part>& from, const std::vector<Part>& to)
{
    return std::ranges::equal(
        from, to, [](const Part& a, const Part& b) { return can_become(*a.mesh(), *b.mesh()); });
}

std::size_t vertex_count(const std::vector<Part>& parts)
{
    std::size_t count = 0;
    for (const Part& part : parts) count += part.rest->vertex_count();
    return count;
}

// Returns the heights over UVs; nothing if the picture lies over each tile, or is missing.
std::optional<TileKind::OverUvs> over_uvs(const HeightShape& shape, const StepInput& input)
{
    if (shape.lies != HeightsLie::uv) return {};
    const Ref<GreyImage> image = input.assets.load_image(shape.image, shape.image_hash).image;
    if (!image || image->values.empty()) return {};
    TileKind::OverUvs out{image, sheet_of(shape)};
    const auto [low, high] = std::ranges::minmax(image->values);
    for (const float each : {low, high})
        out.highest =
            std::max(out.highest, shape.height * (static_cast<double>(each) - shape.level));
    return out;
}

} // namespace

std::size_t KindChoice::of(std::uint32_t seed, double masked_morph, double painted_morph,
                           bool mirrored) const
{
    const Mixed& object = objects[kind_of(seed, weights)];
    const auto phases = static_cast<double>(object.phases);
    const auto phase =
        object.masked
            ? static_cast<std::size_t>(
                  std::lround(std::clamp(masked_morph, 0.0, 1.0) * (phases - 1)))
            : std::min(object.phases - 1, static_cast<std::size_t>(
                                              phases * random_share(seed, random_purpose::phase)));
    std::size_t nearest = 0;
    for (std::size_t m = 1; m < object.morphs; ++m)
        if (std::abs(morphs[m] - painted_morph) < std::abs(morphs[nearest] - painted_morph))
            nearest = m;
    return (mirrored ? images : 0) + object.first + object.morphs * phase + nearest;
}

std::vector<Id> TileKinds::objects_of_meshes() const
{
    std::vector<Id> out;
    for (const TileKind& kind : all)
        for (const Part& part : kind.parts) {
            const auto mesh = static_cast<std::size_t>(part.key.mesh + kind.first_mesh);
            out.resize(std::max(out.size(), mesh + 1));
            out[mesh] = kind.object;
        }
    return out;
}

std::vector<double> painted_morphs(const TileLayout& layout, int phases)
{
    // A step of a sixteenth is not seen as one; with many phases there are fewer of them.
    const double steps = std::clamp(128 / std::max(phases, 1), 2, 16);
    std::set<double> out{0};
    const auto add = [&](double morph) {
        if (morph != 0) out.insert(std::round(morph * steps) / steps);
    };
    for (const Tile& tile : layout.tiles) add(tile.morph);
    for (const StrandCell& cell : layout.strands.cells) add(cell.morph);
    return {out.begin(), out.end()};
}

UnitTile unit_tile(const TileKind& kind, const Part& part, const glm::dmat4& to_unit)
{
    return {part.mesh(), to_unit, kind.first_material, part.posed != nullptr};
}

Box box_at_rest(const std::vector<Part>& parts, const glm::dmat4& turned)
{
    Box box;
    for (const Part& part : parts) box.add(bounding_box(*part.rest, turned * part.to_world));
    return box;
}

double reach_over(const Box& at_rest, const std::vector<Part>& parts, const glm::dmat4& turned)
{
    double reach = at_rest.size().z;
    for (const Part& part : parts)
        if (part.posed)
            reach = std::max(reach, bounding_box(*part.mesh(), turned * part.to_world).hi.z -
                                        at_rest.lo.z);
    return reach;
}

TileLook look_of(const TileKind& kind, const TileLook& look)
{
    TileLook out = look;
    if (!kind.mirrored) return out;
    out.cell_y0 = 1 - look.cell_y1;
    out.cell_y1 = 1 - look.cell_y0;
    out.roll_deg = -look.roll_deg;
    out.alternate_deg = -look.alternate_deg;
    return out;
}

Box unit_cell_in(const Box& box, const TileLook& look)
{
    if (box.empty()) return box;
    const glm::dvec3 size = box.size();
    Box cell = box;
    cell.lo += glm::dvec3(look.cell_x0, look.cell_y0, look.base_level) * size;
    cell.hi -= glm::dvec3(1 - look.cell_x1, 1 - look.cell_y1, 0) * size;
    cell.hi = glm::max(cell.hi, cell.lo + 1e-9 * size);
    return cell;
}

TileCell tile_cell(const std::vector<Part>& parts, const glm::dmat4& turned, const TileLook& look)
{
    const Box whole = box_at_rest(parts, turned), box = unit_cell_in(whole, look);
    const glm::dvec3 size = box.size(), middle = box.center();
    const double side = std::max({size.x, size.y, 1e-6 * size.z, 1e-9});
    TileCell cell{
        {middle.x, middle.y, box.empty() ? 0 : box.lo.z}, side, reach_over(whole, parts, turned)};
    if (box.lo == whole.lo && box.hi == whole.hi) return cell;
    cell.top = std::max(0.0, cell.top - (box.lo.z - whole.lo.z));
    const glm::dvec2 away = glm::max(glm::dvec2(whole.hi - middle), glm::dvec2(middle - whole.lo));
    cell.reach = std::max(1.0, 2 * std::max(away.x, away.y) / side);
    return cell;
}

TileCell tile_cell(const TileKind& kind, const TileLook& look)
{
    TileCell cell = tile_cell(kind.parts, kind.turned, look_of(kind, look));
    if (!kind.from_zero) return cell;
    cell.top = std::max(0.0, cell.middle_of_floor.z + cell.top);
    cell.middle_of_floor.z = 0;
    return cell;
}

Ref<std::vector<Material>> materials_of_others(const TileKinds& kinds)
{
    if (kinds.choice.objects.size() < 2) return nullptr;
    std::vector<Material> all;
    for (const KindChoice::Mixed& each : kinds.choice.objects)
        if (const Ref<std::vector<Material>>& own = kinds.all[each.first].materials)
            all.insert(all.end(), own->begin(), own->end());
    return make_ref(std::move(all));
}

TileKindsOf::Morph TileKindsOf::morph_of_layer(const Stage& layer, const StepInput& input,
                                               std::string& trouble)
{
    const Id id = input.object.tiles->into;
    const auto found = input.done.find(id);
    if (found == input.done.end()) return {};
    const Object& other = object(input.document, id);
    Morph morph{own_parts(*found->second), turned(other)};
    if (can_become(layer.own_parts, morph.into)) return morph;
    const std::size_t from = vertex_count(layer.own_parts), to = vertex_count(morph.into);
    trouble = fmt::format("its tiles cannot become {}: both must have the same vertices and faces, "
                          "but one has {} vertices and the other {}{}",
                          other.name, with_commas(from), with_commas(to),
                          from == to ? ", in other faces" : "");
    return {};
}

void TileKindsOf::move_on(TileKind& kind, const Morph& morph, double share, const TileLook& look)
{
    if (share == 0) return;
    const TileCell own = tile_cell(kind.parts, kind.turned, look),
                   other = tile_cell(morph.into, morph.turned, look);
    // Both fill the same cell.
    glm::dmat4 to_own(own.side / other.side);
    to_own[3] = glm::dvec4(own.middle_of_floor - own.side / other.side * other.middle_of_floor, 1);
    for (std::size_t i = 0; i < kind.parts.size(); ++i) {
        Part& part = kind.parts[i];
        const glm::dmat4 way = glm::inverse(kind.turned * part.to_world) * to_own * morph.turned *
                               morph.into[i].to_world;
        part.posed = morphs_(
            {part.rest.ref(), part.mesh(), morph.into[i].mesh(), way, share},
            [](const MorphInput& in) {
                return make_ref(PosedMesh{
                    in.rest, {}, Lazy<Ref<Mesh>>([in] {
                        return make_ref(morphed(*in.from, transformed(*in.into, in.way), in.share));
                    })});
            });
    }
}

std::vector<TileKind> TileKindsOf::phases_of(Id id, const Stage& stage, const Morph& morph,
                                             const std::vector<double>& painted,
                                             const StepInput& input)
{
    const Object& object = trivar::object(input.document, id);
    const TileLook& look = input.object.tiles->look;
    const Clip* clip = clip_of(*stage.shape, object.playing);
    const bool plays_apart = clip && look.clip_variation > 0,
               masked = !morph.into.empty() && morph_is_masked(*input.object.tiles),
               morphs_apart = masked || (!morph.into.empty() && look.morph_variation > 0);
    const int phases = plays_apart || morphs_apart ? look.phases : 1;
    Posing& posing = posings_[id];
    posing.keep(3 * static_cast<std::size_t>(phases));
    if (!morph.into.empty())
        morphs_.keep(3 * static_cast<std::size_t>(phases) * painted.size() * morph.into.size());
    std::vector<TileKind> out;
    for (int k = 0; k < phases; ++k) {
        TileKind kind{.object = id, .parts = own_parts(stage), .turned = turned(object)};
        if (const auto* heights = std::get_if<HeightShape>(&object.source)) {
            kind.from_zero = true;
            kind.over_uvs = over_uvs(*heights, input);
        }
        if (plays_apart && k > 0) {
            Playing playing = object.playing;
            playing.offset += look.clip_variation * k / phases * (clip->end_s - clip->begin_s);
            kind.parts = parts_in_model(
                *posing(stage.shape, playing, input.seconds_since(playing.start_frame)));
        }
        if (morph.into.empty()) {
            out.push_back(std::move(kind));
            continue;
        }
        const double share = phases > 1 ? k / (phases - 1.0) : 0,
                     all = masked ? look.morph * share : morph_of(look, share);
        for (const double more : painted) { // which leads up to the other shape and not beyond
            TileKind& moved = out.emplace_back(kind);
            const double least = std::min(0.0, all), most = std::max(1.0, all);
            move_on(moved, morph, std::clamp(all + more, least, most), look);
        }
    }
    return out;
}

TileKinds TileKindsOf::operator()(const Stage& layer, const StepInput& input,
                                  const std::vector<double>& painted, bool mirrored)
{
    const Tiling& tiling = *input.object.tiles;
    TileKinds kinds;
    KindChoice& choice = kinds.choice;
    choice.morphs = painted;
    auto materials = static_cast<std::uint32_t>(layer.shape->materials->size());
    int meshes = 0;
    const auto add = [&](std::vector<TileKind> phases, double weight,
                         const Ref<std::vector<Material>>& own, std::size_t morphs) {
        choice.objects.push_back({kinds.all.size(), phases.size() / morphs, morphs});
        choice.weights.push_back(weight);
        for (TileKind& kind : phases) {
            if (own) {
                kind.materials = own;
                kind.first_material = materials;
            }
            kind.first_mesh = meshes;
            for (const Part& part : kind.parts)
                meshes = std::max(meshes, kind.first_mesh + part.key.mesh + 1);
            kinds.all.push_back(std::move(kind));
        }
        if (own) materials += static_cast<std::uint32_t>(own->size());
    };
    const Morph morph = morph_of_layer(layer, input, kinds.trouble);
    add(phases_of(input.id, layer, morph, painted, input), tiling.weight, nullptr,
        morph.into.empty() ? 1 : painted.size());
    choice.objects.front().masked = !morph.into.empty() && morph_is_masked(tiling);
    for (const MixedTile& each : tiling.others) {
        const auto found = input.done.find(each.object);
        if (found == input.done.end() || found->second->parts.empty() ||
            object(input.document, each.object).tiles)
            continue;
        add(phases_of(each.object, *found->second, {}, {}, input), each.weight,
            found->second->materials, 1);
    }
    if (!mirrored) return kinds;
    choice.images = kinds.all.size();
    const int own_meshes = meshes;
    for (std::size_t k = 0; k < choice.images; ++k) {
        TileKind image = kinds.all[k];
        image.mirrored = true;
        image.turned = glm::scale(glm::dmat4(1), glm::dvec3(1, -1, 1)) * image.turned;
        image.first_mesh += own_meshes;
        kinds.all.push_back(std::move(image));
    }
    return kinds;
}

Ref<TileModel> TileKindsOf::model(const TileKind& kind, const Part& part, const TileCell& cell)
{
    return models_({part.mesh(), kind.turned * part.to_world, cell, kind.first_material,
                    part.posed != nullptr},
                   [](const ModelInput& in) {
                       return tile_model(
                           with_materials_from(in_unit_cell(*in.mesh, in.to_model, in.cell),
                                               in.first_material),
                           !in.moves);
                   });
}

} // namespace trivar
