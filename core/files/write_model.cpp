// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/write_model.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/files/flattened.h"
#include "core/files/pictures/image.h"
#include "core/files/writable.h"
#include "core/mesh/extent.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

void check_faces(const Model& model, const std::string& path)
{
    if (holds_curves(path) && line_count(model) > 0) return;
    for (const Node& node : model.nodes)
        if (node.mesh >= 0 &&
            model.meshes.at(static_cast<std::size_t>(node.mesh))->face_count() > 0)
            return;
    throw Rejected(path + ": there are no faces to write, so nothing is written");
}

void check_finite(const Model& model, const std::string& path)
{
    if (too_large(model))
        throw Rejected(
            fmt::format("{}: the model is {}, so nothing is written", path, too_large_words));
    for (const Material& m : model.materials)
        if (!finite(m.base_color) || !finite(m.emissive) ||
            !finite(glm::vec4(m.metallic, m.roughness, m.normal_scale, m.alpha_cutoff)))
            throw Rejected(fmt::format("{}: the material {} has a number that is not finite, so "
                                       "nothing is written",
                                       path, printable(m.name)));
}

// Whether a file can be read and has just these bytes.
bool holds(const std::string& path, const std::string& bytes)
{
    std::error_code unknown;
    if (std::filesystem::file_size(path, unknown) != bytes.size()) return false;
    try {
        return read_bytes(path, bytes.size()) == bytes;
    } catch (const Rejected&) {
        return false;
    }
}

// Writes the files that the OBJ names before it, so that it never names a missing file.
void write_obj_files(const Model& model, const std::string& path, const SourceFiles& sources)
{
    const std::filesystem::path target(path);
    const auto beside = [&](const std::string& name) {
        return (target.parent_path() / name).string();
    };
    // A picture of the same name that is there may be another one.
    const auto is_there = [&](const std::string& name, const Image& image) {
        return as_it_came(image) && holds(beside(name), image.source_bytes);
    };
    const ObjFiles files =
        write_obj(model, target.stem().string(), [&](const std::string& name, const Image& image) {
            std::error_code unknown;
            return !std::filesystem::exists(beside(name), unknown) || is_there(name, image);
        });
    if (!files.mtl.empty()) sources.check(beside(files.mtl_name));
    std::vector<std::pair<std::string, Ref<Image>>> missing;
    for (const auto& [name, image] : files.images)
        if (!is_there(name, *image)) missing.emplace_back(name, image);
    for (const auto& [name, image] : missing) sources.check(beside(name));
    for (const auto& [name, image] : missing) {
        if (as_it_came(*image))
            write_bytes(beside(name), image->source_bytes);
        else
            write_image(*image, beside(name));
    }
    if (!files.mtl.empty()) write_bytes(beside(files.mtl_name), files.mtl);
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

std::string what_is_lost(const Model& model, const std::string& path)
{
    std::string out;
    if (const std::size_t lines = line_count(model); !holds_curves(path) && lines > 0)
        out = fmt::format("{} files have no curves, and {} left out; .glb and .obj have them",
                          extension_of(path), counted(lines, "line was", "lines were"));
    if (const glm::dvec3 far = glm::abs(far_origin(model));
        extension_of(path) == ".stl" && far != glm::dvec3(0))
        out +=
            fmt::format("{}so far from the origin .stl files round places to {} m; .obj, .ply and "
                        ".glb do not",
                        out.empty() ? "" : "; ",
                        number_text(0x1p-23 * std::max({far.x, far.y, far.z}), {.digits = 1}));
    return out;
}

void write_model(const Model& model, const std::string& path, const SourceFiles& sources,
                 GlbOptions glb)
{
    check_model_name(path);
    sources.check(path);
    check_faces(model, path);
    check_finite(model, path);
    check_writable(model, path);
    const std::string extension = extension_of(path);
    if (extension == ".glb")
        write_bytes(path, write_glb(model, glb));
    else if (extension == ".obj")
        write_obj_files(model, path, sources);
    else if (extension == ".ply")
        write_bytes(path, write_ply(model));
    else if (extension == ".stl")
        write_bytes(path, write_stl(model));
    else
        write_bytes(path, write_off(model));
}

} // namespace trivar
