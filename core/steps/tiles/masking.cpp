// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/masking.h"

#include "core/base/parallel.h"
#include "core/placement/placement.h"
#include "core/tiles/strand_masks.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Texture coordinates are read where the mesh is no farther than this share of its diagonal: a
// limit surface lies beside it.
constexpr double near_share = 0.02;
// Tiles keep a size, so that they have a chart; those that are smaller are not shown.
constexpr double least_scale = 1e-3;

bool has_uvs(const TiledPieces& pieces)
{
    return std::ranges::any_of(pieces,
                               [](const TiledPiece& each) { return !each.mesh->uvs.empty(); });
}

std::optional<glm::dvec2> uv_at(const TileBase& base, const SurfacePlace& at)
{
    const std::uint32_t piece = base.piece_of(at.triangle);
    const TileBase::Piece& from = base.pieces()[piece];
    const Mesh& mesh = from.mesh->mesh();
    if (mesh.uvs.empty()) return {};
    const glm::uvec3 corners = base.vertices(at.triangle);
    const std::vector<glm::vec2>& uvs = mesh.uvs.front();
    return at.weights.x * glm::dvec2(uvs[corners.x]) + at.weights.y * glm::dvec2(uvs[corners.y]) +
           at.weights.z * glm::dvec2(uvs[corners.z]);
}

Box box_of(const TiledPieces& pieces)
{
    Box box;
    for (const TiledPiece& each : pieces) box.add(bounding_box(*each.mesh, each.to_model));
    return box;
}

// The lines of an object in the world: its curves, or the middle line of its stroke.
std::vector<std::vector<glm::dvec3>> lines_of(const EvaluatedObject& object)
{
    std::vector<std::vector<glm::dvec3>> out;
    for (const CurvePart& part : object.curves) {
        const Curves curves = in_world(part);
        for (std::size_t l = 0; l < curves.line_count(); ++l) {
            std::vector<glm::dvec3>& line = out.emplace_back();
            for (std::uint32_t k = curves.begin[l]; k < curves.begin[l + 1]; ++k)
                line.emplace_back(curves.points->positions[k]);
        }
    }
    if (const Ref<Placement>& laid = object.stroke_placement();
        out.empty() && laid && !laid->strip.empty()) {
        out.push_back(laid->strip.front());
        for (glm::dvec3& p : out.back()) p = glm::dvec3(object.own_to_world * glm::dvec4(p, 1));
    }
    return out;
}

Ref<LineDistance> distance_to(const EvaluatedObject& curve, const glm::dmat4& to_model)
{
    LineDistance out;
    for (std::vector<glm::dvec3>& line : lines_of(curve)) {
        for (glm::dvec3& p : line) p = glm::dvec3(to_model * glm::dvec4(p, 1));
        out.add(line);
    }
    return make_ref(std::move(out));
}

} // namespace

std::vector<MaskFactors> BaseMasks::at(std::span<const SurfacePoint> places) const
{
    std::vector<std::optional<SurfacePlace>> textured_places(places.size());
    if (textured) textured_places = textured->locate(places, near_share * textured->diagonal());
    std::vector<MaskFactors> out(places.size());
    if (!masks) return out;
    parallel_blocks(out.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            MaskPlace place{places[i].p, places[i].normal, {}};
            if (textured_places[i]) place.uv = uv_at(*textured, *textured_places[i]);
            out[i] = masks->at(place);
        }
    });
    return out;
}

FoundMasks MasksOf::operator()(const TiledPieces& pieces, const StepInput& input)
{
    const Tiling& tiling = *input.object.tiles;
    FoundMasks found;
    if (tiling.masks.empty()) return found;
    TileMasks all;
    for (std::size_t k = 0; k < tiling.masks.size(); ++k) {
        ReadyMask ready{tiling.masks[k]};
        const TileMask& mask = ready.mask;
        if (mask.hidden) continue;
        const auto tell = [&](std::string_view what) {
            found.notices.push_back(fmt::format("mask {}: {}", k + 1, what));
        };
        if (mask.from == MaskFrom::image) {
            AssetStore::LoadedImage loaded = input.assets.load_image(mask.image, mask.image_hash);
            for (const std::string& notice : loaded.notices) tell(notice);
            if (!loaded.image) {
                found.lacks.push_back(found.notices.back());
                continue;
            }
            ready.image = std::move(loaded.image);
            if (mask.lies == MaskLies::uv && !has_uvs(pieces)) {
                tell("what it lies on has no texture coordinates; let the picture lie along an "
                     "axis");
                continue;
            }
        } else if (mask.from == MaskFrom::curve) {
            const auto there = input.done.find(mask.curve);
            if (there == input.done.end()) {
                tell("its curve is no longer there; choose another one");
                continue;
            }
            const Object& base = object(input.document, tiling.base);
            ready.curve =
                lines_({there->second,
                        base.stroke ? glm::dmat4(1) : to_world(input.document, tiling.base)},
                       [](const LineInput& in) {
                           return distance_to(*in.curve, glm::inverse(in.to_world));
                       });
            if (ready.curve->empty()) {
                tell(fmt::format("{} has no curve and lies on no stroke",
                                 object(input.document, mask.curve).name));
                continue;
            }
        }
        all.all.push_back(std::move(ready));
    }
    if (all.all.empty()) return found;
    all.box = box_of(pieces);
    found.on_base.masks = masks_(all, [](const TileMasks& in) { return make_ref(in); });
    if (found.on_base.masks->read_uvs()) {
        std::vector<TileBase::Piece> meshes;
        for (const TiledPiece& piece : pieces)
            meshes.push_back({input.ray_meshes(piece.mesh, input.timings), piece.to_model});
        found.on_base.textured = textured_(meshes, [](const std::vector<TileBase::Piece>& in) {
            return std::make_shared<const TileBase>(in);
        });
    }
    return found;
}

MasksOf::MaskedLayout MasksOf::masked(const Ref<TileBase>& base, const Ref<TileLayout>& layout,
                                      const BaseMasks& masks)
{
    if (!masks.masks) return {layout, nullptr};
    return layouts_({base, layout, masks}, [](const LayoutInput& in) -> MaskedLayout {
        std::vector<SurfacePoint> places;
        for (const Tile& tile : in.layout->tiles)
            places.push_back({in.base->position(tile.at), in.base->normal(tile.at)});
        MaskedLayout out{in.layout, make_ref(in.masks.at(places))};
        if (in.layout->strands.cells.empty() && !in.masks.drive(MaskDrives::scale)) return out;
        TileLayout sized = *in.layout;
        std::vector<Tile> tiles = in.layout->tiles.all();
        for (std::size_t i = 0; i < tiles.size(); ++i)
            tiles[i].size *= std::max((*out.factors)[i].scale, least_scale);
        sized.tiles = Runs<Tile>::cut(tiles);
        places.clear();
        for (const StrandStation& each : in.layout->strands.stations)
            places.push_back({in.base->position(each.at), in.base->normal(each.at)});
        mask_strands(sized.strands, in.masks.at(places));
        out.layout = make_ref(std::move(sized));
        return out;
    });
}

} // namespace trivar
