// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/every_command.h"
#include "core/document/asset_store.h"
#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"
#include "core/document/named_files.h"
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

// The digest of a file that was read. Throws Rejected where it could not be.
std::string digest_of_read(const auto& loaded, bool whole, const std::string& path)
{
    if (!whole)
        throw Rejected(loaded.notices.empty() ? path + ": cannot be read" : loaded.notices.front());
    return loaded.hash;
}

// Stores the digest of the font that was found, or none if another one replaces it. A font file
// gets an absolute path, so that it is found wherever the scene is kept.
void prepare_font(std::string& font, std::string& digest, const AssetStore& assets)
{
    if (is_font_path(font))
        font = std::filesystem::absolute(assets.resolve(font)).lexically_normal().string();
    digest.clear();
    try {
        const FoundFont found = find_font(font);
        if (found.notices.empty()) digest = found.font.digest();
    } catch (const Rejected&) { // reported for the object
    }
}

// Names a file as the log does, with the digest of its present content. Volume data without levels
// get the one that parts their values best. Throws Rejected where the file cannot be read.
template <class Name, class Owner>
void prepare_file(const Name& file, Owner& owner, const AssetStore& assets,
                  const Progress& progress)
{
    if (file.kind == FileKind::font) return prepare_font(file.path, file.digest, assets);
    if (file.kind != FileKind::model && (!file.in_use || file.path.empty())) return;
    file.path = path_in_log(file.path, assets.folder());
    if constexpr (std::is_same_v<Owner, ImportedFile>) {
        file.digest.clear(); // any content
        const auto loaded = assets.load(owner, progress);
        file.digest = digest_of_read(loaded, loaded.model != nullptr, file.path);
    } else if (file.kind == FileKind::image) {
        const auto loaded = assets.load_image(file.path, {});
        file.digest = digest_of_read(loaded, loaded.image != nullptr, file.path);
    } else {
        const auto loaded = assets.load_volume(file.path, {}, progress, reading_of(owner));
        file.digest = digest_of_read(loaded, loaded.grid != nullptr, file.path);
        if constexpr (std::is_same_v<Owner, VoxelShape>)
            if (owner.levels.empty())
                owner.levels.push_back({.value = usual_level(*loaded.summary, *loaded.grid)});
    }
}

// An object without a name of its own is called as its file.
void give_name(std::string& name, const std::string& path, std::string_view none = {})
{
    if (name.empty() || name == none) name = std::filesystem::path(path).stem().string();
}

} // namespace

Command prepare(Command command, const AssetStore& assets, const Progress& progress)
{
    change(command, [&]<class C>(C& c) {
        if constexpr (std::is_same_v<C, Relink>) return; // it names files that were read before
        each_file(c, [&](const auto& file, auto& owner) {
            if constexpr (!std::is_same_v<C, Paste>)
                prepare_file(file, owner, assets, progress);
            else if (file.kind != FileKind::font && !file.path.empty())
                file.path = path_in_log(file.path, assets.folder()); // if missing, it is said
        });
        if constexpr (std::is_same_v<C, ImportModel>) give_name(c.name, c.file.path);
        if constexpr (std::is_same_v<C, AddVoxels>)
            give_name(c.name, c.shape.path, FieldsOf<VoxelShape>::name);
        if constexpr (requires { c.files.front().file; })
            for (TileFile& each : c.files) give_name(each.name, each.file.path);
    });
    return command;
}

} // namespace trivar
