// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/volume_names.h"

#include "core/files/file_bytes.h"
#include "core/voxels/read_volume.h"
#include "ui/file_entries.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace trivar {
namespace fs = std::filesystem;

const std::vector<std::string>& volume_extensions()
{
    static const std::vector<std::string> extensions{".nrrd", ".nhdr", ".nii", ".nii.gz", ".mha",
                                                     ".mhd",  ".vtk",  ".vti", ".dcm",    ".raw",
                                                     ".bin",  ".dat",  ".vol"};
    return extensions;
}

bool is_volume(const std::string& path)
{
    std::error_code ignored;
    return fs::is_directory(path, ignored) ||
           ui::has_extension(fs::path(path).filename().string(), volume_extensions()) ||
           is_volume_file(path);
}

bool is_raw_volume(const std::string& path)
{
    static constexpr std::array raw{".raw", ".bin", ".dat", ".vol"};
    return std::ranges::find(raw, extension_of(path)) != raw.end();
}

std::string volume_name(const std::string& path)
{
    fs::path named(path);
    if (!named.has_filename()) named = named.parent_path();
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return named.filename().string();
    if (ui::has_extension(named.filename().string(), {".nii.gz"})) named = named.stem();
    return named.stem().string();
}

} // namespace trivar
