// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/source_files.h"

#include "core/base/rejected.h"

#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>

namespace trivar {
namespace {

std::optional<std::pair<std::uint64_t, std::uint64_t>> identity_of(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return std::pair<std::uint64_t, std::uint64_t>(status.st_dev, status.st_ino);
}

} // namespace

void SourceFiles::add(const std::string& path)
{
    if (const auto identity = identity_of(path)) known_.insert(*identity);
}

void SourceFiles::check(const std::string& written) const
{
    if (known_.empty()) return;
    const auto identity = identity_of(written);
    if (!identity || !known_.contains(*identity)) return;
    throw Rejected(fmt::format(
        "{}: the scene uses this file, which would be overwritten; choose another name{}{}",
        written, or_else_.empty() ? "" : ", ", or_else_));
}

} // namespace trivar
