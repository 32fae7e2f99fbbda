// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/sample_models.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

constexpr const char* maker = "trivar-make";

// A SampleOrder names what the maker is asked for, and the folder for it; empty: it makes no such
// file.
struct SampleOrder {
    std::string name;
    fs::path folder;
};
SampleOrder order_for(const fs::path& file, const fs::path& made_by)
{
    const fs::path models = made_by.parent_path() / "assets" / "models";
    if (file.extension() == ".glb" && file.parent_path() == models)
        return {file.stem().string(), models};
    if (file.extension() == ".obj" && file.parent_path() == models / "cages")
        return {"cages", models}; // all at once
    if (file.extension() == ".png" && file.parent_path() == models / "pictures")
        return {"pictures", models};
    if (file.extension() == ".nrrd" && file.parent_path() == models / "volumes")
        return {"volumes/" + file.stem().string(), models};
    return {};
}

} // namespace

bool can_be_made(const std::string& path, const fs::path& program)
{
    std::error_code ignored;
    const fs::path file = fs::absolute(path, ignored).lexically_normal();
    const std::string name = file.stem().string();
    const bool is_named_so = !name.empty() && std::ranges::all_of(name, [](char c) {
        return c == '_' || (c >= 'a' && c <= 'z');
    });
    if (!is_named_so || fs::exists(file, ignored)) return false;
    const fs::path made_by = part_of(program, maker);
    return !made_by.empty() && !order_for(file, made_by).name.empty();
}

void make_sample_model(const std::string& path, const Progress& progress, const fs::path& program)
{
    if (!can_be_made(path, program)) return;
    const fs::path file = fs::absolute(path).lexically_normal();
    report(progress, 0, "making " + file.filename().string());
    const SampleOrder order = order_for(file, part_of(program, maker));
    std::string made_by = part_of(program, maker).string(), folder = order.folder.string(),
                name = order.name, quiet = "--quiet";
    const std::array<char*, 5> arguments{made_by.data(), folder.data(), name.data(), quiet.data(),
                                         nullptr};
    pid_t id = -1;
    if (::posix_spawn(&id, made_by.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
        return;
    int status = 0;
    while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
}

} // namespace trivar
