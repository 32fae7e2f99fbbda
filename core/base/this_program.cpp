// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/this_program.h"

namespace trivar {

std::filesystem::path this_program()
{
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

std::filesystem::path part_of(const std::filesystem::path& program, std::string_view name)
{
    const std::filesystem::path beside = program.parent_path();
    std::error_code ignored;
    for (const auto& folder : {beside, beside.parent_path() / "lib" / "trivar"})
        if (std::filesystem::is_regular_file(folder / name, ignored)) return folder / name;
    return {};
}

} // namespace trivar
