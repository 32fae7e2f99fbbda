// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/volume_offer.h"

#include "core/base/memory.h"
#include "core/base/rejected.h"
#include "core/level/field_slabs.h"
#include "core/voxels/dicom_file.h"
#include "core/voxels/segments.h"
#include "editor/files/volume_names.h"
#include "editor/session/volume_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

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

// DICOM files in it would be read, and they say how far their samples are apart.
bool is_folder_of_pictures(const std::string& path)
{
    namespace fs = std::filesystem;
    std::error_code error;
    if (!fs::is_directory(path, error)) return false;
    for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        if (!at->is_regular_file(ignored)) continue; // reading a pipe would wait
        std::array<char, 256> head;
        std::ifstream file(at->path(), std::ios::binary);
        file.read(head.data(), head.size());
        if (is_dicom({head.data(), static_cast<std::size_t>(file.gcount())})) return false;
    }
    return true;
}

VolumeReading reading_of(const RawLayout& layout)
{
    const auto& n = layout.block.size;
    return {.size = {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])},
            .type = layout.block.type,
            .order = layout.order,
            .header_bytes = static_cast<int>(layout.header_bytes)};
}

Keeping keeping_of(GridPart part, int coarsen)
{
    part.coarsen = coarsen;
    return {coarsen, part.count() * part.bytes_per_sample,
            part.count() * field_bytes(part.bytes_per_sample, {})};
}

// Chooses the reading's coarsening if it fits, else the finest that does.
void choose_keeping(VolumeOffer& offer, VolumeReading& reading, const Progress& progress)
{
    offer.part = offer.assets->part_of_volume(offer.path, reading, progress);
    offer.keepings = keepings(offer.part, offer.memory_bytes);
    if (offer.keepings.empty())
        throw Rejected(fmt::format("{}: its {} x {} x {} samples do not fit into the memory, "
                                   "however coarse",
                                   std::filesystem::path(offer.path).filename().string(),
                                   offer.part.whole.x, offer.part.whole.y, offer.part.whole.z));
    reading.coarsen = std::max(reading.coarsen, offer.keepings.front().coarsen);
}

} // namespace

std::vector<Keeping> keepings(GridPart part, std::uint64_t memory_bytes)
{
    constexpr int most_coarsening = 64;
    constexpr std::size_t most_ways = 8; // a list of more is no help
    std::vector<Keeping> out;
    for (int n = 1; n <= most_coarsening && out.size() < most_ways; ++n) {
        const Keeping each = keeping_of(part, n);
        const bool same = !out.empty() && out.back().bytes == each.bytes; // it has no more to merge
        if (each.working_bytes <= memory_bytes && !same) out.push_back(each);
    }
    return out;
}

std::uint64_t volume_memory()
{
    constexpr std::uint64_t least = std::uint64_t{1} << 30;
    // The reader's own bound is on samples alone, and no lower.
    const std::uint64_t most = ReadVolumeOptions{}.memory_bytes, all = physical_bytes();
    return all == 0 ? least : std::min<std::uint64_t>(all / 2, most);
}

bool asks_what_is_kept(const VolumeOffer& offer)
{
    constexpr std::uint64_t large = std::uint64_t{256} << 20; // bytes
    return !offer.keepings.empty() && (offer.command.shape.reading.coarsen > 1 ||
                                       offer.keepings.front().working_bytes > large);
}

std::string bytes_words(std::uint64_t bytes)
{
    const auto b = static_cast<double>(bytes);
    if (b < 1e6) return fmt::format("{:.0f} KB", std::max(1.0, b / 1e3));
    if (b < 1e9) return fmt::format("{:.{}f} MB", b / 1e6, b < 1e8 ? 1 : 0);
    return fmt::format("{:.2f} GB", b / 1e9);
}

std::string words_of(const Keeping& keeping)
{
    const std::string bytes = bytes_words(keeping.bytes);
    if (keeping.coarsen == 1) return "Every voxel, " + bytes;
    return fmt::format("1 for {} per axis, {}", keeping.coarsen, bytes);
}

VolumeOffer offer_of(const std::string& path, const VolumeReading& reading,
                     const Ref<AssetStore>& assets, std::uint64_t memory_bytes,
                     const Progress& progress)
{
    VolumeOffer out;
    out.path = path;
    out.assets = assets;
    out.memory_bytes = memory_bytes;
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
        choose_keeping(out, asked.shape.reading, progress);
        out.command = prepare(asked, *assets, progress).get<AddVoxels>();
        const AssetStore::LoadedVolume loaded = assets->load_volume(
            out.command.shape.path, out.command.shape.hash, progress, out.command.shape.reading);
        if (!loaded.grid)
            throw Rejected(loaded.notices.empty() ? "It cannot be read." : loaded.notices.front());
        out.grid = loaded.grid;
        out.summary = loaded.summary;
        out.notices = loaded.notices;
        if (const Keeping all = keeping_of(out.part, 1); all.working_bytes > memory_bytes)
            out.notices.insert(
                out.notices.begin(),
                fmt::format("every voxel would take {}, {} with what the window makes of them, "
                            "more than the {} that volume data may take; one voxel for {} along "
                            "each axis is kept, their mean",
                            bytes_words(all.bytes), bytes_words(all.working_bytes),
                            bytes_words(memory_bytes), out.command.shape.reading.coarsen));
    } catch (const Rejected& why) {
        if (!out.raw) throw;
        out.trouble = why.what();
        return out;
    }
    out.slices = middle_slices(*out.grid, *out.summary);
    VoxelShape& shape = out.command.shape;
    std::vector<VolumeSegment> segments = segments_of(path);
    if (segments.empty())
        segments.push_back({.level = shape.levels.front().value});
    else
        shape.spline = FieldSpline::smoothing; // between labels nothing rings
    shape.levels.clear();
    for (const VolumeSegment& each : segments) {
        shape.levels.push_back(new_level(shape, each.level));
        shape.levels.back().name = each.name;
    }
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
