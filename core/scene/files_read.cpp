// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files_read.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/document/named_files.h"
#include "core/files/companions.h"
#include "core/stages/shapes.h"
#include <filesystem>
#include <utility>

namespace trivar {
namespace {

std::string content_of(const ImportedFile& file, const AssetStore& assets, bool missing_is_well)
{
    const AssetStore::LoadedModel loaded = assets.load(file);
    if (loaded.hash.empty() && !missing_is_well)
        throw Rejected(loaded.notices.empty() ? file.path + ": cannot be read"
                                              : loaded.notices.front());
    return loaded.content;
}

std::string content_of_image(const std::string& path, const AssetStore& assets,
                             bool missing_is_well)
{
    const AssetStore::LoadedImage loaded = assets.load_image(path, {});
    if (loaded.hash.empty() && !missing_is_well)
        throw Rejected(loaded.notices.empty() ? path + ": cannot be read" : loaded.notices.front());
    return loaded.hash;
}

std::string content_of(const VoxelShape& shape, const AssetStore& assets, bool missing_is_well)
{
    const AssetStore::LoadedVolume loaded = assets.load_volume(shape.path, {}, {}, shape.reading);
    if (loaded.hash.empty() && !missing_is_well)
        throw Rejected(loaded.notices.empty() ? shape.path + ": cannot be read"
                                              : loaded.notices.front());
    return loaded.hash;
}

std::string content_of(const TextShape& text, const AssetStore& assets)
{
    try {
        return font_of(text, assets).font.digest();
    } catch (const Rejected&) { // reported for the object, which has no shape
        return {};
    }
}

void add_companions(SourceFiles& files, const std::string& path)
{
    try {
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        for (const std::string& name : companions_of(path)) files.add((folder / name).string());
    } catch (const Rejected&) { // an unreadable file names no others
    }
}

} // namespace

std::string digest_of_files(const Document& document, const AssetStore& assets,
                            bool missing_is_well)
{
    std::map<std::string, std::string> contents; // by name in the scene
    for (const auto& [id, object] : document.objects)
        if (const auto* file = std::get_if<ImportedFile>(&object->source)) {
            if (!contents.contains(file->path))
                contents[file->path] = content_of(*file, assets, missing_is_well);
        } else if (const auto* text = std::get_if<TextShape>(&object->source)) {
            contents["font " + text->font] = content_of(*text, assets);
        } else if (const auto* voxels = std::get_if<VoxelShape>(&object->source)) {
            contents["volume " + voxels->path] = content_of(*voxels, assets, missing_is_well);
        }
    for (const auto& [id, object] : document.objects)
        for (const NamedFile& file : files_named(*object))
            if (file.kind == NamedFile::Kind::image)
                contents["image " + file.path] =
                    content_of_image(file.path, assets, missing_is_well);
    if (contents.empty()) return {};
    Digest digest;
    for (const auto& [name, content] : contents) {
        digest.add_text(name);
        digest.add_text(content);
    }
    return digest.hex();
}

SourceFiles source_files(const Document& document, const AssetStore& assets, const std::string& log,
                         std::string or_else)
{
    SourceFiles files(std::move(or_else));
    if (!log.empty())
        for (const char* kept : {"", ".torn"}) files.add(log + kept);
    for (const auto& [id, object] : document.objects)
        for (const NamedFile& file : files_named(*object)) {
            const std::string path = assets.resolve(file.path);
            files.add(path);
            if (file.kind == NamedFile::Kind::model) add_companions(files, path);
            if (file.kind == NamedFile::Kind::volume)
                for (const std::string& each :
                     files_of_volume(std::get<VoxelShape>(object->source), assets))
                    files.add(each);
        }
    return files;
}

} // namespace trivar
