// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/named_files.h"

#include "core/text/installed_fonts.h"

#include <filesystem>

namespace trivar {

std::vector<NamedFile> files_named(const Object& object)
{
    std::vector<NamedFile> out;
    if (const auto* file = std::get_if<ImportedFile>(&object.source))
        out.push_back({NamedFile::Kind::model, file->path});
    if (const auto* text = std::get_if<TextShape>(&object.source); text && is_font_path(text->font))
        out.push_back({NamedFile::Kind::font, text->font});
    if (const auto* voxels = std::get_if<VoxelShape>(&object.source))
        out.push_back({NamedFile::Kind::volume, voxels->path});
    for (UsedPicture& picture : pictures_of(object))
        out.push_back({NamedFile::Kind::image, std::move(picture.path)});
    return out;
}

std::vector<std::string> files_of_volume(const VoxelShape& shape, const AssetStore& assets)
{
    const std::filesystem::path path = std::filesystem::absolute(assets.resolve(shape.path));
    const AssetStore::LoadedVolume loaded = assets.load_volume(shape.path, {}, {}, shape.reading);
    if (loaded.hash.empty()) return {};
    const bool is_folder = std::filesystem::is_directory(path);
    std::vector<std::string> out;
    if (!is_folder) out.push_back(path.string());
    for (const std::string& name : loaded.companions)
        out.push_back(((is_folder ? path : path.parent_path()) / name).string());
    return out;
}

std::vector<UsedPicture> pictures_of(const Object& object)
{
    std::vector<UsedPicture> out;
    if (const auto* heights = std::get_if<HeightShape>(&object.source))
        out.push_back({0, heights->image, heights->image_hash});
    int number = 0;
    if (object.tiles)
        for (const TileMask& mask : object.tiles->masks) {
            ++number;
            if (mask.from == MaskFrom::image && !mask.image.empty())
                out.push_back({number, mask.image, mask.image_hash});
        }
    return out;
}

} // namespace trivar
