// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/moved_history.h"

#include "core/scene/kept_scenes.h"

#include <algorithm>
#include <map>
#include <utility>

namespace trivar {
namespace {

// Returns the names of the files that a command names, which can be changed if the command can.
template <class C> auto files_of(C& command)
{
    using Name = std::conditional_t<std::is_const_v<C>, const std::string, std::string>;
    std::vector<Name*> files;
    const auto add = [&](auto& name) {
        if (!name.empty()) files.push_back(&name);
    };
    if (auto* import = std::get_if<ImportModel>(&command)) add(import->file.path);
    if (auto* edit = std::get_if<EditImport>(&command)) add(edit->file.path);
    if (auto* relink = std::get_if<Relink>(&command)) {
        for (auto& file : relink->files) add(file.path);
        for (auto& picture : relink->pictures) add(picture.image);
        for (auto& volume : relink->volumes) add(volume.path);
    }
    if (auto* kept = std::get_if<KeepShape>(&command))
        for (auto& file : kept->files) add(file.path);
    if (auto* final_shape = std::get_if<ApplyShape>(&command)) add(final_shape->file.path);
    if (auto* mask = std::get_if<MaskTiles>(&command)) add(mask->mask.image);
    if (auto* heights = std::get_if<AddHeights>(&command)) add(heights->shape.image);
    if (auto* heights = std::get_if<SetHeights>(&command)) add(heights->shape.image);
    if (auto* heights = std::get_if<Displace>(&command)) add(heights->shape.image);
    if (auto* voxels = std::get_if<AddVoxels>(&command)) add(voxels->shape.path);
    if (auto* voxels = std::get_if<SetVoxels>(&command)) add(voxels->shape.path);
    const auto add_tiles = [&](auto& tile_files) {
        for (auto& each : tile_files) add(each.file.path);
    };
    if (auto* paint = std::get_if<PaintTiles>(&command)) add_tiles(paint->files);
    if (auto* cover = std::get_if<CoverWithTiles>(&command)) add_tiles(cover->files);
    if (auto* mix = std::get_if<MixTiles>(&command)) add_tiles(mix->files);
    if (auto* paste = std::get_if<Paste>(&command))
        for (auto& copy : paste->copies) {
            if (copy.file) add(copy.file->path);
            if (copy.heights) add(copy.heights->image);
            if (copy.voxels) add(copy.voxels->path);
            if (copy.tiling)
                for (auto& mask : copy.tiling->masks) add(mask.mask.image);
        }
    return files;
}

bool is_relative(const std::string* file)
{
    return std::filesystem::path(*file).is_relative();
}

std::filesystem::path absolute(const std::string& file, const std::filesystem::path& folder)
{
    return (folder / file).lexically_normal();
}

// Finds a name for a copy of the file that is free or has the same content.
std::filesystem::path place_for(const std::filesystem::path& file,
                                const std::filesystem::path& folder)
{
    const auto usable = [&](const std::string& path) {
        std::error_code ignored;
        return !std::filesystem::exists(path, ignored) || same_content(path, file);
    };
    const std::string path = (folder / file.filename()).string();
    return usable(path) ? path : numbered_name(path, usable);
}

// NewPaths maps the old path of a file to its new one, both absolute.
using NewPaths = std::map<std::filesystem::path, std::filesystem::path>;

NewPaths shapes_brought(const History& history, const std::filesystem::path& from,
                        const std::filesystem::path& to, Copies& copies)
{
    NewPaths brought;
    const auto bring = [&](const std::string& file) {
        const std::filesystem::path path = absolute(file, from);
        std::error_code ignored;
        if (brought.contains(path) || !is_kept_shape(path, from) ||
            !std::filesystem::is_regular_file(path, ignored))
            return;
        const std::filesystem::path place = place_for(path, to).lexically_normal();
        if (!std::filesystem::exists(place, ignored)) copies.copy(path, place);
        brought[path] = place;
    };
    history.retell(
        [&](const History::Step& step) {
            for (const std::string* file : files_of(step.command)) bring(*file);
        },
        [] {});
    return brought;
}

History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to, const NewPaths& brought)
{
    History result;
    history.retell(
        [&](const History::Step& step) {
            Command command = step.command;
            for (std::string* file : files_of(command)) {
                if (!is_relative(file)) continue;
                const std::filesystem::path path = absolute(*file, from);
                const auto found = brought.find(path);
                const std::filesystem::path& now = found == brought.end() ? path : found->second;
                *file = now.lexically_relative(to).string();
            }
            result.run(std::move(command), step.note);
        },
        [&] { result.undo(); });
    return result;
}

} // namespace

bool imports_by_relative_path(const History& history)
{
    bool found = false;
    history.retell(
        [&](const History::Step& step) {
            found = found || std::ranges::any_of(files_of(step.command), is_relative);
        },
        [] {});
    return found;
}

History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to)
{
    return moved(history, from, to, {});
}

std::optional<History> moved_with_shapes(const History& history, const std::filesystem::path& from,
                                         const std::filesystem::path& to, Copies& copies)
{
    if (from == to || !imports_by_relative_path(history)) return {};
    return moved(history, from, to, shapes_brought(history, from, to, copies));
}

} // namespace trivar
