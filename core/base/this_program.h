// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace trivar {

// The file of the running program; empty where the system does not tell.
std::filesystem::path this_program();

// The path of a part of Trivar that is a file of its own: beside the program, as the build puts it,
// or in lib/trivar beside the program's folder, as `cmake --install` puts it. Empty: it is in
// neither.
std::filesystem::path part_of(const std::filesystem::path& program, std::string_view name);

} // namespace trivar
