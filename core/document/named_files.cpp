// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/named_files.h"

#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"
#include "core/text/installed_fonts.h"

#include <filesystem>

namespace trivar {

bool is_file_path(FileKind kind, const std::string& path)
{
    return !path.empty() && (kind != FileKind::font || is_font_path(path));
}

std::vector<FileUse> files_named(const Object& object)
{
    std::vector<FileUse> out;
    each_file(object, [&](const auto& file, const auto& owner) {
        if (!file.in_use || !is_file_path(file.kind, file.path)) return;
        out.push_back({file.kind, file.path, file.digest, file.entry, reading_of(owner)});
    });
    return out;
}

std::vector<std::string> files_of_volume(const FileUse& volume, const AssetStore& assets)
{
    const std::filesystem::path path = std::filesystem::absolute(assets.resolve(volume.path));
    const AssetStore::LoadedVolume loaded = assets.load_volume(volume.path, {}, {}, volume.reading);
    if (loaded.hash.empty()) return {};
    const bool is_folder = std::filesystem::is_directory(path);
    std::vector<std::string> out;
    if (!is_folder) out.push_back(path.string());
    for (const std::string& name : loaded.companions)
        out.push_back(((is_folder ? path : path.parent_path()) / name).string());
    return out;
}

} // namespace trivar
