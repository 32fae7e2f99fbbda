// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/plain_text.h"
#include "core/mesh/far_origin.h"
#include "core/mesh/repair.h"
#include "core/mesh/shading.h"
#include "core/mesh/transform.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <utility>

namespace trivar {
namespace {

constexpr std::size_t max_notices = 20;

ObjModel read_format(const FileText& file, const std::string& extension, const Progress& progress)
{
    if (extension == ".obj") return read_obj(file, progress);
    if (extension == ".ply") return {read_ply(file, progress), {}};
    if (extension == ".stl") return {read_stl(file, progress), {}};
    if (extension == ".off") return {read_off(file, progress), {}};
    if (extension == ".gltf") {
        refuse_wide_text(file.bytes, file.name);
        return {read_gltf(file, false, progress), {}};
    }
    if (extension == ".glb") return {read_gltf(file, true, progress), {}};
    throw Rejected(
        fmt::format("{}: models are read from .obj, .ply, .stl, .off, .gltf and .glb", file.name));
}

// Completes normals that the file lacks: glTF demands flat faces (specification 3.7.2.1), STL has
// facets, OBJ may say it by smoothing groups; otherwise faces that bend more are taken for an edge.
void complete_normals(Mesh& mesh, const FileText& file, const std::vector<std::uint32_t>& smoothing)
{
    const std::string extension = extension_of(file.name);
    const bool flat = extension == ".stl" || extension == ".gltf" || extension == ".glb";
    mesh = with_normals_of_faces(std::move(mesh), flat ? 0 : usual_edge_deg, smoothing);
    for (glm::vec4& t : mesh.tangents) {
        const float length = glm::length(glm::vec3(t));
        t = length > 0 && std::isfinite(length) ? glm::vec4(glm::vec3(t) / length, t.w < 0 ? -1 : 1)
                                                : glm::vec4(1, 0, 0, 1);
    }
}

// Reads the file again relative to a point near its model where that is far from 0: whether it is
// can be told only from all of it. A glTF file has positions in single precision and places in
// double precision already.
ObjModel read_near(FileText& file, const std::string& extension, const Progress& progress)
{
    constexpr int most_tries = 3; // rounding hides where a model is that is very small there
    for (int i = 0;; ++i) {
        ObjModel read = read_format(file, extension, progress);
        if (extension == ".gltf" || extension == ".glb") return read;
        Box box;
        for (const Ref<Mesh>& mesh : read.model.meshes) box.add(bounding_box(*mesh));
        for (const Ref<Curves>& curves : read.model.curves) box.add(bounding_box(*curves->points));
        const glm::dvec3 further = far_origin(box);
        if (i == most_tries || further == glm::dvec3(0)) return read;
        file.origin += further;
    }
}

// Puts a model that was read relative to a point where the file has it.
void put_far(Model& model, const FileText& file, const glm::dmat4& to_world)
{
    const glm::dvec3 place(to_world * glm::dvec4(file.origin, 1));
    for (Node& node : model.nodes)
        if (node.parent < 0) node.to_parent = glm::translate(glm::dmat4(1), place);
    model.notices.push_back(
        fmt::format("{}: it lies {} m from the origin; its place is kept in double precision, "
                    "apart from its shape, so that it loses no detail",
                    file.name, number_text(glm::length(place))));
}

RepairedMesh finished(Mesh mesh, const FileText& file, const ReadOptions& options,
                      const std::vector<std::uint32_t>& smoothing)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (mesh.face_begin[f + 1] - mesh.face_begin[f] > max_face_corners)
            throw Rejected(fmt::format("{}: face {} has more than {} corners", file.name, f,
                                       with_commas(max_face_corners)));
    // Faces may go: while the mesh is repaired, their numbers stand for their groups.
    std::vector<std::uint32_t> smooth, groups = mesh.face_group;
    if (!smoothing.empty()) {
        mesh.face_group.resize(mesh.face_count());
        std::iota(mesh.face_group.begin(), mesh.face_group.end(), 0u);
    }
    RepairedMesh result = repaired(std::move(mesh));
    if (!smoothing.empty())
        for (const std::uint32_t f : std::exchange(result.mesh.face_group, {})) {
            smooth.push_back(smoothing[f]);
            if (!groups.empty()) result.mesh.face_group.push_back(groups[f]);
        }
    if (options.normals_of_faces) complete_normals(result.mesh, file, smooth);
    validate(result.mesh, file.name);
    return result;
}

void check_size(const std::vector<glm::vec3>& positions, const FileText& file,
                const ReadOptions& options)
{
    if (!std::ranges::all_of(positions, [](const auto& p) { return finite(p); }))
        throw Rejected(fmt::format("{}: the scale {} makes it larger than numbers can say "
                                   "(3.4e38); choose a smaller scale",
                                   file.name, options.scale));
}

void leave_out_empty_meshes(Model& model)
{
    std::vector<int> number;
    std::vector<Ref<Mesh>> kept;
    for (const Ref<Mesh>& mesh : model.meshes) {
        number.push_back(mesh->face_count() == 0 ? -1 : static_cast<int>(kept.size()));
        if (number.back() >= 0) kept.push_back(mesh);
    }
    for (Node& node : model.nodes)
        if (node.mesh >= 0) node.mesh = number[static_cast<std::size_t>(node.mesh)];
    model.meshes = std::move(kept);
}

glm::dmat4 to_world(const ReadOptions& options, bool y_up_format)
{
    const bool y_up = options.up == UpAxis::y || (options.up == UpAxis::automatic && y_up_format);
    glm::dmat4 matrix(1);
    if (y_up) matrix = glm::dmat4({1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1});
    for (int i = 0; i < 3; ++i) matrix[i] *= options.scale;
    return matrix;
}

} // namespace

Model read_model_bytes(std::string_view bytes, const std::string& name, const std::string& folder,
                       const ReadOptions& options, const Progress& progress)
{
    if (!(options.scale >= 1e-9 && options.scale <= 1e9))
        throw Rejected(
            fmt::format("{}: the scale must be between 1e-9 and 1e9, not {}", name, options.scale));
    FileText file{bytes, std::filesystem::path(name).filename().string(), folder};
    if (bytes.size() > options.max_bytes)
        throw Rejected(fmt::format("{}: has {} bytes, more than the {} allowed", file.name,
                                   with_commas(bytes.size()), with_commas(options.max_bytes)));
    if (bytes.empty()) throw Rejected(file.name + ": the file is empty");
    const std::string extension = extension_of(name);
    const bool gltf = extension == ".gltf" || extension == ".glb";
    auto [model, smoothing] = read_near(file, extension, progress);

    report(progress, 0.9, "Checking");
    const glm::dmat4 matrix = to_world(options, gltf || extension == ".obj");
    if (file.origin != glm::dvec3(0)) put_far(model, file, matrix);
    std::size_t faces = 0, vertices = 0;
    Repairs repairs;
    for (Ref<Mesh>& ref : model.meshes) {
        vertices += ref->vertex_count();
        RepairedMesh result = finished(*ref, file, options, smoothing);
        repairs += result.repairs;
        Mesh mesh = std::move(result.mesh);
        faces += mesh.face_count();
        if (!gltf && matrix != glm::dmat4(1)) {
            transform_again(mesh, mesh, matrix);
            check_size(mesh.positions, file, options);
        }
        ref = make_ref(std::move(mesh));
    }
    std::size_t lines = 0;
    for (Ref<Curves>& ref : model.curves) {
        if (!gltf && matrix != glm::dmat4(1)) ref = make_ref(transformed(*ref, matrix));
        check_size(ref->points->positions, file, options);
        validate(*ref, file.name);
        lines += ref->line_count();
    }
    if (faces == 0 && lines == 0)
        throw Rejected(repairs.dropped > 0
                           ? file.name + ": none of its faces has three different corners"
                       : vertices > 0 ? points_alone(file.name)
                                      : file.name + ": it has no faces and no lines");
    for (const std::string& sentence : sentences(repairs))
        model.notices.push_back(fmt::format("{}: {}", file.name, sentence));
    if (model.materials.empty()) { // vertex colours are used unchanged
        const bool colored = std::ranges::any_of(
            model.meshes, [](const Ref<Mesh>& mesh) { return !mesh->colors.empty(); });
        model.materials.push_back(colored ? Material() : unpainted());
    }
    for (Node& node : model.nodes) {
        if (node.parent < 0 && gltf) {
            node.to_parent = matrix * node.to_parent;
            node.outer = matrix * node.outer;
        }
        if (node.name.empty()) node.name = std::filesystem::path(file.name).stem().string();
    }
    leave_out_empty_meshes(model);
    if (model.notices.size() > max_notices) {
        const std::size_t more = model.notices.size() - max_notices;
        model.notices.resize(max_notices);
        model.notices.push_back(
            fmt::format("{}: and {} more notices", file.name, with_commas(more)));
    }
    report(progress, 1, "Done");
    return model;
}

Model read_model(const std::string& path, const ReadOptions& options, const Progress& progress)
{
    report(progress, 0, "Opening");
    const std::string bytes = read_bytes(path, options.max_bytes);
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    return read_model_bytes(bytes, path, folder.string(), options, progress);
}

} // namespace trivar
