// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/volume_offer.h"

#include "core/base/rejected.h"
#include "editor/files/volume_names.h"
#include "editor/session/volume_levels.h"

#include <cmath>
#include <filesystem>

namespace trivar {
namespace {

glm::dvec3 turn_of(DataUp up)
{
    switch (up) {
    case DataUp::z: return {0, 0, 0};
    case DataUp::minus_z: return {180, 0, 0};
    case DataUp::y: return {90, 0, 0};
    case DataUp::minus_y: return {-90, 0, 0};
    case DataUp::x: return {0, -90, 0};
    case DataUp::minus_x: return {0, 90, 0};
    }
    return {};
}

Box bounds_of(const VolumeOffer& offer, const Transform& transform)
{
    Box out;
    const glm::dmat4 to_scene = transform.matrix() *
                                glm::dmat4(glm::dmat3(offer.command.shape.scale * offer.scale)) *
                                offer.grid->to_metres;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at(glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) *
                            (offer.grid->size - 1));
        out.add(glm::dvec3(to_scene * glm::dvec4(at, 1)));
    }
    return out;
}

bool is_folder_of_pictures(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

VolumeReading reading_of(const RawLayout& layout)
{
    const auto& n = layout.block.size;
    return {.size = {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])},
            .type = layout.block.type,
            .order = layout.order,
            .header_bytes = static_cast<int>(layout.header_bytes)};
}

} // namespace

VolumeOffer offer_of(const std::string& path, const VolumeReading& reading,
                     const Ref<AssetStore>& assets, const Progress& progress)
{
    VolumeOffer out;
    out.path = path;
    out.assets = assets;
    out.raw = is_raw_volume(path);
    AddVoxels asked;
    asked.shape.path = path;
    asked.shape.reading = reading;
    asked.name = volume_name(path);
    if (out.raw) {
        std::error_code ignored;
        const auto bytes = std::filesystem::file_size(path, ignored);
        out.guesses = raw_guesses(std::filesystem::path(path).filename().string(), bytes);
        if (reading.size.x == 0 && !out.guesses.empty()) {
            const glm::dvec3 spacing = reading.spacing_mm;
            asked.shape.reading = reading_of(out.guesses.front().layout);
            asked.shape.reading.spacing_mm = spacing;
        }
    }
    out.says_no_spacing = out.raw || is_folder_of_pictures(path);
    out.command = asked;
    try {
        out.command = std::get<AddVoxels>(prepare(asked, *assets, progress));
        const AssetStore::LoadedVolume loaded = assets->load_volume(
            out.command.shape.path, out.command.shape.hash, progress, out.command.shape.reading);
        if (!loaded.grid)
            throw Rejected(loaded.notices.empty() ? "It cannot be read." : loaded.notices.front());
        out.grid = loaded.grid;
        out.summary = loaded.summary;
        out.notices = loaded.notices;
    } catch (const Rejected& why) {
        if (!out.raw) throw;
        out.trouble = why.what();
        return out;
    }
    out.slices = middle_slices(*out.grid, *out.summary);
    VoxelShape& shape = out.command.shape;
    const double value = shape.levels.front().value;
    shape.levels.clear();
    shape.levels.push_back(new_level(shape, value));
    return out;
}

AddVoxels command_of(const VolumeOffer& offer)
{
    AddVoxels out = offer.command;
    out.transform.rotation_deg = turn_of(offer.up);
    out.shape.scale = offer.command.shape.scale * offer.scale;
    if (!offer.centered || !offer.grid) return out;
    const Box box = bounds_of(offer, out.transform);
    const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6; };
    out.transform.translation = {rounded(-box.center().x), rounded(-box.center().y),
                                 rounded(-box.lo.z)};
    return out;
}

glm::dvec3 size_of(const VolumeOffer& offer)
{
    if (!offer.grid) return {};
    Transform turned;
    turned.rotation_deg = turn_of(offer.up);
    return bounds_of(offer, turned).size();
}

} // namespace trivar
