// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "core/patches/tile_set.h"
#include "core/tiles/strand_tile.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

// A flat patch of a metre, and one beside it that is bent.
std::vector<trivar::PlacedTile> two_places()
{
    std::vector<trivar::PlacedTile> out(2);
    for (std::size_t tile = 0; tile < 2; ++tile) {
        std::array<glm::dvec3, 16> p{}, n{};
        for (std::size_t k = 0; k < 16; ++k) {
            const double x = trivar::patch_nodes[k % 4], y = trivar::patch_nodes[k / 4];
            p[k] = {x + static_cast<double>(tile), y, 0.2 * static_cast<double>(tile) * x * y};
            n[k] = {0.1 * static_cast<double>(tile) * y, 0, 1};
        }
        out[tile].patch = {trivar::through_nodes(p), trivar::through_nodes(n)};
    }
    out[1].tint = {0.5f, 0.2f, 1};
    return out;
}

std::string_view name_of(std::string_view bytes)
{
    return bytes.starts_with("glTF")  ? "fuzz.glb"
           : bytes.starts_with("ply") ? "fuzz.ply"
                                      : "fuzz.obj";
}

} // namespace

// Any bytes are a model that can be painted with, as one that is dropped on the library of tiles
// is, or Rejected: in a strand and on patches of its own, with positions that are finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const trivar::Model model =
            trivar::read_model_bytes(bytes, std::string(name_of(bytes)), "");
        const std::vector<trivar::PlacedTile> places = two_places();
        for (const trivar::Ref<trivar::Mesh>& mesh : model.meshes) {
            const trivar::Box box = trivar::bounding_box(*mesh);
            if (box.empty() || mesh->vertex_count() > 5000) continue;
            const glm::dvec3 extent = box.size(), middle = box.center();
            const double side = std::max({extent.x, extent.y, 1e-6 * extent.z, 1e-9});
            trivar::Mesh unit = trivar::in_unit_cell(
                *mesh, glm::dmat4(1), {{middle.x, middle.y, box.lo.z}, side, extent.z});
            const trivar::StrandTile strand = trivar::strand_tile(unit);
            if (strand.mesh.vertex_count() != mesh->vertex_count()) std::abort();
            const auto tile = trivar::tile_model(std::move(unit));
            for (const trivar::TileLevel& level : *tile->levels)
                trivar::validate(*level.mesh, "level");
            const auto set = trivar::tile_set(tile, trivar::make_ref(trivar::PlacedTiles(places)));
            for (const trivar::Ref<trivar::Mesh>& all :
                 {*set->mesh, trivar::make_ref(trivar::strand_mesh(strand.mesh, places))}) {
                trivar::validate(*all, "tiles");
                for (const glm::vec3& p : all->positions)
                    if (!trivar::finite(p)) std::abort();
            }
        }
    } catch (const trivar::Rejected&) {
        return 0;
    }
    return 0;
}
