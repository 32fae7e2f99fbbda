// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sound_files.h"

#include "core/base/text.h"
#include "core/files/flattened.h"
#include "core/files/formats.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/pictures/image.h"
#include "tests/fuzz/sound_models.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trivar::testing {
namespace {

// Features that other programs write and our writer does not.
constexpr const char* other_obj = R"(mtllib other.mtl
v 0 0 0 1
v 1 0 0 1 0.5 0.5
v 1 1 0
v 0 1 0
vt 0 0
vn 0 0 1
g a b
s 1
usemtl wood
f -4/1/1 -3/1/1 -2/1/1 \
  -1/1/1
l 1 2
f 1//1 3//1 4//1
t crease 2/1/0 0 1 3.5
)";
constexpr const char* other_mtl = R"(newmtl wood
Ka 0 0 0
Kd 0.5 0.4 0.3
Ks 1 1 1
Ns 10
Tr 0.2
illum 2
map_Kd -s 1 1 1 -o 0 0 0 wood.png
map_Bump -bm 0.5 wood.png
norm wood.png
)";

FileSet obj_files(const Model& model)
{
    const ObjFiles written = write_obj(model, "model");
    FileSet out{{"model.obj", written.obj}, {"model.mtl", written.mtl}};
    for (const auto& [name, image] : written.images)
        out.push_back({name, encoded_image(*image, ".png")});
    return out;
}

std::string ply_text(const Model& model)
{
    const Mesh mesh = flattened(model);
    std::string out =
        fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.vertex_count());
    for (const char* name : {"float x", "float y", "double z", "uchar red"})
        out += fmt::format("property {}\n", name);
    out += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                       mesh.face_count());
    for (const glm::vec3& p : mesh.positions) out += fmt::format("{} {} {} 200\n", p.x, p.y, p.z);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        out += fmt::format("{}", mesh.face_begin[f + 1] - mesh.face_begin[f]);
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            out += fmt::format(" {}", mesh.corners[c]);
        out += '\n';
    }
    return out;
}

std::string stl_text(const Model& model)
{
    const Mesh mesh = flattened(model);
    std::string out = "solid body\n";
    for (const glm::uvec3& t : triangles(mesh)) {
        out += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : {t.x, t.y, t.z}) {
            const glm::vec3& p = mesh.positions[v];
            out += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
        }
        out += "endloop\nendfacet\n";
    }
    return out + "endsolid body\n";
}

// The same model with its buffer and its pictures in files of their own.
FileSet gltf_files(const Model& model)
{
    const GlbChunks chunks = glb_chunks(write_glb(model));
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(chunks.json);
    json["buffers"][0]["uri"] = "model.bin";
    FileSet out{{"model.gltf", ""}, {"model.bin", chunks.binary}};
    if (json.contains("images"))
        for (auto& image : json["images"]) {
            const auto& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
            const std::string name = fmt::format("picture_{}.png", out.size());
            out.push_back({name, chunks.binary.substr(view.value("byteOffset", 0u),
                                                      view["byteLength"].get<std::size_t>())});
            image.erase("bufferView");
            image["uri"] = name;
        }
    out.front().bytes = json.dump();
    return out;
}

std::vector<FileSet> seeds(const std::string& folder, const std::string& extension)
{
    const std::filesystem::path all = TRIVAR_SOURCE_DIR "/tests/fuzz/seeds/" + folder;
    if (!std::filesystem::is_directory(all)) return {};
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(all))
        if (entry.path().extension() == extension) paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<FileSet> out;
    for (const auto& path : paths)
        out.push_back({{path.filename().string(), read_text_file(path.string())}});
    return out;
}

FileSet written(const std::string& kind, const Model& model)
{
    if (kind == "obj") return obj_files(model);
    if (kind == "gltf") return gltf_files(model);
    if (kind == "glb") return {{"model.glb", write_glb(model)}};
    if (kind == "off") return {{"model.off", write_off(model)}};
    if (kind == "stl") return {{"model.stl", write_stl(model)}};
    if (kind == "stl-text") return {{"model.stl", stl_text(model)}};
    if (kind == "ply") return {{"model.ply", write_ply(model)}};
    return {{"model.ply", ply_text(model)}};
}

} // namespace

std::vector<FileSet> sound_files(const std::string& kind)
{
    std::vector<FileSet> out = seeds(kind == "glb" ? "gltf" : kind, "." + kind);
    for (const Model& model : sound_models()) out.push_back(written(kind, model));
    if (kind == "obj") {
        const std::string picture = obj_files(sound_models().front()).back().bytes;
        out.push_back({{"other.obj", other_obj}, {"other.mtl", other_mtl}, {"wood.png", picture}});
    }
    return out;
}

} // namespace trivar::testing
