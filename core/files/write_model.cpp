// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/write_model.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/formats.h"
#include "core/files/image.h"
#include "core/files/writable.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

// What the OBJ names is written before it, so that it never names what is not there.
void write_obj_files(const Model& model, const std::string& path)
{
    const std::filesystem::path target(path);
    const ObjFiles files = write_obj(model, target.stem().string());
    for (const auto& [name, image] : files.images) {
        const std::string picture = (target.parent_path() / name).string();
        const bool as_it_came = !image->source_bytes.empty() && image->mime == "image/jpeg";
        if (as_it_came)
            write_bytes(picture, image->source_bytes);
        else
            write_image(*image, picture);
    }
    if (!files.mtl.empty())
        write_bytes((target.parent_path() / (target.stem().string() + ".mtl")).string(), files.mtl);
    write_bytes(path, files.obj);
}

} // namespace

void check_model_name(const std::string& path)
{
    static constexpr std::array<std::string_view, 5> known{".glb", ".obj", ".ply", ".stl", ".off"};
    if (std::ranges::find(known, extension_of(path)) == known.end())
        throw Rejected(
            fmt::format("{}: models are written as .glb, .obj, .ply, .stl and .off", path));
}

void write_model(const Model& model, const std::string& path)
{
    check_model_name(path);
    check_writable(model, path);
    const std::string extension = extension_of(path);
    if (extension == ".glb")
        write_bytes(path, write_glb(model));
    else if (extension == ".obj")
        write_obj_files(model, path);
    else if (extension == ".ply")
        write_bytes(path, write_ply(model));
    else if (extension == ".stl")
        write_bytes(path, write_stl(model));
    else
        write_bytes(path, write_off(model));
}

} // namespace trivar
