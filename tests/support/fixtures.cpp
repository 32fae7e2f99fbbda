// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"

#include <cstdlib>
#include <fstream>

namespace trivar::testing {

TemporaryFolder::TemporaryFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "trivar-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void write_file(const std::filesystem::path& path, const std::string& bytes)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string real_data_folder()
{
    if (const char* named = std::getenv("TRIVAR_DATA")) return named;
    const auto beside = std::filesystem::path(TRIVAR_SOURCE_DIR) / "../shared/data";
    std::error_code error;
    return std::filesystem::is_directory(beside, error) ? beside.string() : std::string();
}

} // namespace trivar::testing
