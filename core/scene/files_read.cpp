// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files_read.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"
#include "core/document/named_files.h"
#include "core/files/companions.h"
#include "core/stages/shapes.h"

#include <array>
#include <filesystem>
#include <map>
#include <utility>

namespace trivar {
namespace {

// The digest of what a file holds; a font that is named by its family counts. Empty: it is missing.
template <class Name, class Owner>
std::string content_of(const Name& file, const Owner& owner, const AssetStore& assets,
                       bool missing_is_well)
{
    const auto whole = [&](const auto& loaded, const std::string& content) {
        if (loaded.hash.empty() && !missing_is_well)
            throw Rejected(loaded.notices.empty() ? file.path + ": cannot be read"
                                                  : loaded.notices.front());
        return content;
    };
    if constexpr (std::is_same_v<Owner, ImportedFile>) {
        const AssetStore::LoadedModel loaded = assets.load(owner);
        return whole(loaded, loaded.content);
    }
    if (file.kind == FileKind::image) {
        const AssetStore::LoadedImage loaded = assets.load_image(file.path, {});
        return whole(loaded, loaded.hash);
    }
    if (file.kind == FileKind::volume) {
        const AssetStore::LoadedVolume loaded =
            assets.load_volume(file.path, {}, {}, reading_of(owner));
        return whole(loaded, loaded.hash);
    }
    try {
        TextShape text;
        text.font = file.path;
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
    constexpr std::array<std::string_view, 4> kinds{"", "font ", "image ", "volume "};
    for (const auto& [id, object] : document.objects)
        each_file(*object, [&](const auto& file, const auto& owner) {
            if (!file.in_use || file.path.empty()) return;
            const auto kind = kinds.at(static_cast<std::size_t>(file.kind));
            const auto [entry, fresh] = contents.try_emplace(std::string(kind) + file.path);
            if (fresh) entry->second = content_of(file, owner, assets, missing_is_well);
        });
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
        for (const FileUse& file : files_named(*object)) {
            const std::string path = assets.resolve(file.path);
            files.add(path);
            if (file.kind == FileKind::model) add_companions(files, path);
            if (file.kind == FileKind::volume)
                for (const std::string& each : files_of_volume(file, assets)) files.add(each);
        }
    return files;
}

} // namespace trivar
