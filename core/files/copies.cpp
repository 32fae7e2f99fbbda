// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/copies.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"

#include <fmt/format.h>
#include <unistd.h>

namespace trivar {

namespace fs = std::filesystem;

bool same_content(const fs::path& a, const fs::path& b)
{
    std::error_code ignored;
    return fs::equivalent(a, b, ignored) ||
           (fs::file_size(a, ignored) == fs::file_size(b, ignored) &&
            file_hash(a.string()) == file_hash(b.string()));
}

std::string numbered_name(const std::string& path,
                          const std::function<bool(const std::string&)>& usable)
{
    const fs::path file(path);
    std::string stem = file.stem().string();
    const std::size_t bar = stem.rfind('_');
    if (bar != stem.npos && bar > 0 && bar + 1 < stem.size() &&
        stem.find_first_not_of("0123456789", bar + 1) == stem.npos)
        stem.resize(bar);
    std::error_code ignored;
    for (int n = 1;; ++n) {
        const std::string name =
            (file.parent_path() / fmt::format("{}_{:03}{}", stem, n, file.extension().string()))
                .string();
        if (usable ? usable(name) : !fs::exists(name, ignored)) return name;
    }
}

Copies::~Copies()
{
    std::error_code ignored;
    for (auto each = made_.rbegin(); each != made_.rend(); ++each) fs::remove(*each, ignored);
}

void Copies::make_folder(const fs::path& folder)
{
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) return;
    make_folder(folder.parent_path());
    if (!fs::create_directory(folder, error))
        throw Rejected(fmt::format("{}: the folder cannot be created ({})", folder.string(),
                                   error ? error.message() : "a file of that name exists"));
    made_.push_back(folder);
}

void Copies::copy(const fs::path& from, const fs::path& to)
{
    make_folder(to.parent_path());
    const fs::path beside = to.string() + fmt::format(".{}.part", ::getpid());
    made_.push_back(beside);
    std::error_code error;
    const bool copied = fs::copy_file(from, beside, fs::copy_options::none, error);
    if (copied) fs::rename(beside, to, error);
    if (!copied || error)
        throw Rejected(fmt::format("{}: cannot be copied to {} ({}); nothing has changed",
                                   from.filename().string(), to.parent_path().string(),
                                   error.message()));
    made_.back() = to;
}

} // namespace trivar
