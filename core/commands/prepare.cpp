// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/every_command.h"
#include "core/commands/objects/keep_shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/apply_shape.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/document/asset_store.h"
#include "core/document/fields/view_fields.h"
#include "core/text/installed_fonts.h"
#include "core/voxels/usual_level.h"

#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

// Makes a path relative if the file is in or near the folder of the scene, so that both can be
// moved together.
std::string path_in_log(const std::string& path, const std::string& folder)
{
    const std::filesystem::path named(path);
    if (named.is_relative()) return named.lexically_normal().string();
    const std::filesystem::path relative = named.lexically_normal().lexically_relative(folder);
    const auto ups = std::count(relative.begin(), relative.end(), std::filesystem::path(".."));
    constexpr auto near = 3;
    return relative.empty() || ups > near ? named.lexically_normal().string() : relative.string();
}

// Returns the file as the log names it, with the hash of its present content.
ImportedFile prepared(ImportedFile file, const AssetStore& assets, const Progress& progress)
{
    file.path = path_in_log(file.path, assets.folder());
    file.hash.clear(); // any content
    const AssetStore::LoadedModel loaded = assets.load(file, progress);
    if (!loaded.model)
        throw Rejected(loaded.notices.empty() ? file.path + ": cannot be read"
                                              : loaded.notices.front());
    file.hash = loaded.hash;
    return file;
}

// Names a picture as the log does, with the hash of its present content. Throws Rejected where it
// cannot be read.
void prepare_image(std::string& path, std::string& hash, const AssetStore& assets)
{
    if (path.empty()) return;
    path = path_in_log(path, assets.folder());
    const AssetStore::LoadedImage loaded = assets.load_image(path, {});
    if (!loaded.image)
        throw Rejected(loaded.notices.empty() ? path + ": cannot be read" : loaded.notices.front());
    hash = loaded.hash;
}

void prepare_image(HeightShape& shape, const AssetStore& assets)
{
    prepare_image(shape.image, shape.image_hash, assets);
}

// Volume data with the hash of their present content; without levels they get the one that parts
// their values best. Throws Rejected where they cannot be read.
void prepare_voxels(VoxelShape& shape, const AssetStore& assets, const Progress& progress)
{
    if (shape.path.empty()) return;
    shape.path = path_in_log(shape.path, assets.folder());
    const AssetStore::LoadedVolume loaded =
        assets.load_volume(shape.path, {}, progress, shape.reading);
    if (!loaded.grid)
        throw Rejected(loaded.notices.empty() ? shape.path + ": cannot be read"
                                              : loaded.notices.front());
    shape.hash = loaded.hash;
    if (shape.levels.empty())
        shape.levels.push_back({.value = usual_level(*loaded.summary, *loaded.grid)});
}

// Stores the digest of the font that was found, or none if another one replaces it. A font file
// gets an absolute path, so that it is found wherever the scene is kept.
void prepare_font(TextShape& text, const AssetStore& assets)
{
    if (is_font_path(text.font))
        text.font =
            std::filesystem::absolute(assets.resolve(text.font)).lexically_normal().string();
    text.font_digest.clear();
    try {
        const FoundFont found = find_font(text.font);
        if (found.notices.empty()) text.font_digest = found.font.digest();
    } catch (const Rejected&) { // reported for the object
    }
}

// The models of tiles; each without a name gets that of its file.
void prepare_tiles(std::vector<TileFile>& files, const AssetStore& assets, const Progress& progress)
{
    for (TileFile& each : files) {
        each.file = prepared(std::move(each.file), assets, progress);
        if (each.name.empty()) each.name = std::filesystem::path(each.file.path).stem().string();
    }
}

} // namespace

Command prepare(Command command, const AssetStore& assets, const Progress& progress)
{
    if (auto* import = command.edit<ImportModel>()) {
        import->file = prepared(std::move(import->file), assets, progress);
        if (import->name.empty())
            import->name = std::filesystem::path(import->file.path).stem().string();
    } else if (auto* edit = command.edit<EditImport>()) {
        edit->file = prepared(std::move(edit->file), assets, progress);
    } else if (auto* kept = command.edit<KeepShape>()) {
        for (ImportedFile& file : kept->files) file = prepared(std::move(file), assets, progress);
    } else if (auto* final_shape = command.edit<ApplyShape>()) {
        final_shape->file = prepared(std::move(final_shape->file), assets, progress);
    } else if (auto* text = command.edit<AddText>()) {
        prepare_font(text->shape, assets);
    } else if (auto* letters = command.edit<SetText>()) {
        prepare_font(letters->shape, assets);
    } else if (auto* mask = command.edit<MaskTiles>()) {
        if (mask->mask.from == MaskFrom::image)
            prepare_image(mask->mask.image, mask->mask.image_hash, assets);
    } else if (auto* sheet = command.edit<AddHeights>()) {
        prepare_image(sheet->shape, assets);
    } else if (auto* other = command.edit<SetHeights>()) {
        prepare_image(other->shape, assets);
    } else if (auto* displace = command.edit<Displace>()) {
        prepare_image(displace->shape, assets);
    } else if (auto* voxels = command.edit<AddVoxels>()) {
        prepare_voxels(voxels->shape, assets, progress);
        if (voxels->name.empty() || voxels->name == FieldsOf<VoxelShape>::name)
            voxels->name = std::filesystem::path(voxels->shape.path).stem().string();
    } else if (auto* changed = command.edit<SetVoxels>()) {
        prepare_voxels(changed->shape, assets, progress);
    } else if (auto* paint = command.edit<PaintTiles>()) {
        prepare_tiles(paint->files, assets, progress);
    } else if (auto* cover = command.edit<CoverWithTiles>()) {
        prepare_tiles(cover->files, assets, progress);
    } else if (auto* mix = command.edit<MixTiles>()) {
        prepare_tiles(mix->files, assets, progress);
    } else if (auto* paste = command.edit<Paste>()) {
        const auto in_log = [&](std::string& path) {
            if (!path.empty()) path = path_in_log(path, assets.folder());
        };
        for (CopiedObject& copy : paste->copies) { // a missing file is reported for each object
            if (copy.file) in_log(copy.file->path);
            if (copy.heights) in_log(copy.heights->image);
            if (copy.voxels) in_log(copy.voxels->path);
            if (copy.tiling)
                for (CopiedMask& each : copy.tiling->masks) in_log(each.mask.image);
        }
    }
    return command;
}

} // namespace trivar
