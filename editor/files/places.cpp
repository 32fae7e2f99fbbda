// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/places.h"

namespace trivar {

Places places_of(const std::filesystem::path& program)
{
    std::error_code ignored;
    const std::filesystem::path above = program.parent_path().parent_path();
    const std::filesystem::path installed = above / "share" / "trivar";
    const bool is_installed = std::filesystem::is_directory(installed / "assets", ignored);
    const std::filesystem::path root = is_installed ? installed : above;
    const std::filesystem::path documents = is_installed ? installed : above / "docs";
    const auto folder = [&](const std::filesystem::path& path) {
        return std::filesystem::is_directory(path, ignored) ? path.string() : std::string();
    };
    return {folder(root / "assets" / "scenes"), folder(root / "assets" / "tutorials"),
            folder(documents / "manual"), folder(documents / "gallery"),
            folder((is_installed ? root : program.parent_path()) / "assets" / "models")};
}

} // namespace trivar
