// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/document/command.h"

#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

// Relative where the file lies in or near the scene's folder, so that both can move together.
std::string path_in_log(const std::string& path, const std::string& folder)
{
    const std::filesystem::path named(path);
    if (named.is_relative()) return named.lexically_normal().string();
    const std::filesystem::path relative = named.lexically_normal().lexically_relative(folder);
    const auto ups = std::count(relative.begin(), relative.end(), std::filesystem::path(".."));
    constexpr auto near = 3;
    return relative.empty() || ups > near ? named.lexically_normal().string() : relative.string();
}

} // namespace

Command prepare(Command command, const AssetStore& assets, const Progress& progress)
{
    auto* import = std::get_if<ImportModel>(&command);
    if (!import) return command;
    import->file.path = path_in_log(import->file.path, assets.folder());
    ImportedFile any_content = import->file;
    any_content.hash.clear();
    const AssetStore::Loaded loaded = assets.load(any_content, progress);
    if (!loaded.model)
        throw Rejected(loaded.notices.empty() ? import->file.path + ": cannot be read"
                                              : loaded.notices.front());
    import->file.hash = loaded.hash;
    if (import->name.empty())
        import->name = std::filesystem::path(import->file.path).stem().string();
    return command;
}

} // namespace trivar
