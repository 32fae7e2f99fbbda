// SPDX-License-Identifier: GPL-3.0-or-later
// Every model that comes with Trivar, and real ones: what is written is read again, and is the same
// to the precision of its format; as it came, posed by its clip, and with morph targets.
#include "core/files/flattened.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/pose.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

struct Format {
    std::string extension;
    bool normals = false, uvs = false, materials = false;
};
const std::vector<Format> formats{{".glb", true, true, true},
                                  {".obj", true, true, true},
                                  {".ply", true, true},
                                  {".stl"},
                                  {".off"}};

std::vector<std::string> models_in(const std::string& folder)
{
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        for (const char* extension : {".glb", ".gltf", ".obj", ".ply", ".stl", ".off"})
            if (entry.path().extension() == extension) out.push_back(entry.path().string());
    std::sort(out.begin(), out.end());
    return out;
}

// The meshes as a clip has them in its middle, or as they came, each on a node without a parent.
Model posed_model(const Model& model, const Clip* clip)
{
    const Stance stance = stance_at(model, clip, clip ? 0.5 * (clip->begin_s + clip->end_s) : 0);
    Model out;
    out.materials = model.materials;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const int node = static_cast<int>(i);
        if (model.nodes[i].mesh < 0) continue;
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(model.nodes[i].mesh)];
        out.nodes.push_back({model.nodes[i].name, -1, mesh_to_model(model, node, stance),
                             static_cast<int>(out.meshes.size())});
        out.meshes.push_back(make_ref(posed(mesh, pose_of(model, node, stance))));
    }
    return out;
}

// With a target that swells each mesh and one whose differences are all 0, of normals too.
Model with_targets(Model model)
{
    for (Ref<Mesh>& ref : model.meshes) {
        Mesh mesh = *ref;
        const std::vector<glm::vec3> zeros(mesh.vertex_count(), glm::vec3(0));
        mesh.morph_targets = {{mesh.normals, zeros, {}}, {zeros, zeros, {}}};
        ref = make_ref(std::move(mesh));
    }
    for (Node& node : model.nodes) node.morph_weights = {0.25f, 0.5f};
    for (Clip& clip : model.clips)
        std::erase_if(clip.channels, [](const Channel& channel) {
            return channel.of == Channel::Of::morph_weights;
        });
    std::erase_if(model.clips, [](const Clip& clip) { return clip.channels.empty(); });
    return model;
}

// With triangles in place of polygons, as two of the formats have it; a polygon that meets itself
// in a point has some that are none.
Model in_triangles(Model model)
{
    for (Ref<Mesh>& ref : model.meshes) {
        Mesh mesh = *ref;
        const std::vector<glm::uvec3> all = triangles(mesh);
        mesh.corners.clear(), mesh.face_begin = {0}, mesh.face_material.clear();
        for (std::size_t f = 0; f < ref->face_count(); ++f)
            for (std::size_t t = ref->face_begin[f] - 2 * f; t + 2 * f + 2 < ref->face_begin[f + 1];
                 ++t) {
                const std::array corners{all[t].x, all[t].y, all[t].z};
                const auto p = [&](std::size_t k) { return mesh.positions[corners[k]]; };
                if (p(0) == p(1) || p(1) == p(2) || p(2) == p(0)) continue;
                add_face(mesh, corners);
                mesh.face_material.push_back(ref->face_material.empty() ? 0
                                                                        : ref->face_material[f]);
            }
        ref = make_ref(std::move(mesh));
    }
    return model;
}

struct Corner {
    glm::vec3 position, normal;
    glm::vec2 uv;
    std::uint32_t material;
};

// Returns the corners of all faces of all nodes at their places, mesh by mesh, or those of a mesh
// by their materials, as in GLB.
std::vector<Corner> corners(const Model& model, bool by_material)
{
    std::vector<Corner> out;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0) continue;
        const Mesh mesh = transformed(*model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)],
                                      node_to_model(model, static_cast<int>(n)));
        const auto begin = static_cast<std::ptrdiff_t>(out.size());
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::size_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                const std::uint32_t v = mesh.corners[c];
                out.push_back({mesh.positions[v],
                               mesh.normals.empty() ? glm::vec3(0) : mesh.normals[v],
                               mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[0][v],
                               mesh.face_material.empty() ? 0 : mesh.face_material[f]});
            }
        const auto less = [](const Corner& a, const Corner& b) { return a.material < b.material; };
        if (by_material) std::stable_sort(out.begin() + begin, out.end(), less);
    }
    return out;
}

bool same_material(const Material& a, const Material& b)
{
    const Ref<Image>&x = a.base_color_texture.image, &y = b.base_color_texture.image;
    return glm::distance(a.base_color, b.base_color) < 1e-6f &&
           std::abs(a.roughness - b.roughness) < 1e-6f &&
           std::abs(a.metallic - b.metallic) < 1e-6f &&
           glm::distance(a.emissive, b.emissive) < 1e-6f && !x == !y && (!x || x->rgba == y->rgba);
}

void expect_same(const Model& written, const Model& back, const Format& format)
{
    const bool by_material = format.extension == ".glb";
    const std::vector<Corner> a = corners(written, by_material), b = corners(back, by_material);
    ASSERT_EQ(a.size(), b.size());
    double size = 0, places = 0, normals = 0, uvs = 0, uv_size = 1;
    for (const Corner& each : a) {
        size = std::max(size, double(glm::length(each.position)));
        uv_size = std::max(uv_size, double(glm::length(each.uv)));
    }
    for (std::size_t c = 0; c < a.size(); ++c) {
        places = std::max(places, double(glm::distance(a[c].position, b[c].position)));
        normals = std::max(normals, double(glm::distance(a[c].normal, b[c].normal)));
        uvs = std::max(uvs, double(glm::distance(a[c].uv, b[c].uv)));
    }
    EXPECT_LE(places, 1e-6 * size);
    EXPECT_TRUE(!format.normals || normals <= 1e-4) << normals;
    EXPECT_TRUE(!format.uvs || uvs <= 1e-6 * uv_size) << uvs;
    for (std::size_t c = 0; format.materials && c < a.size(); ++c) {
        if (c > 0 && a[c].material == a[c - 1].material) continue;
        EXPECT_TRUE(same_material(written.materials[a[c].material], back.materials[b[c].material]));
    }
}

// Sentences without the file's name.
std::vector<std::string> said(const Model& model)
{
    std::vector<std::string> out;
    for (const std::string& notice : model.notices)
        out.push_back(notice.substr(notice.find(": ") + 2));
    return out;
}

void expect_it_comes_back(const Model& model, const Format& format)
{
    const TemporaryFolder folder; // for the materials and pictures of an OBJ
    const std::string path = folder.file("model" + format.extension);
    const bool alone = format.extension != ".obj";
    if (!alone) write_model(model, path);
    const Model back =
        alone ? read_model_bytes(bytes_of(model, format.extension), path, "") : read_model(path);
    // A triangle of a face that comes back to one of its points is left out, with its own vertices.
    const auto is_of_a_flat_triangle = [](const std::string& notice) {
        return notice.find("fewer than three different") != notice.npos;
    };
    const bool some_are_flat = std::ranges::any_of(said(back), is_of_a_flat_triangle);
    for (const std::string& notice : said(back))
        EXPECT_TRUE(std::ranges::count(said(model), notice) > 0 || is_of_a_flat_triangle(notice) ||
                    (some_are_flat && notice.find("no face uses") != notice.npos))
            << notice;
    if (format.extension == ".stl")
        return expect_same(in_triangles(single_mesh_model("", flattened(model))), back, format);
    if (format.extension != ".glb") return expect_same(model, back, format);
    const Model cut = in_triangles(model);
    expect_same(posed_model(cut, nullptr), posed_model(back, nullptr), format);
    ASSERT_EQ(back.clips.size(), model.clips.size());
    for (std::size_t c = 0; c < model.clips.size(); ++c) {
        EXPECT_EQ(back.clips[c].name, model.clips[c].name);
        expect_same(posed_model(cut, &model.clips[c]), posed_model(back, &back.clips[c]), format);
    }
}

void expect_all_come_back(const std::string& folder)
{
    for (const std::string& path : models_in(folder)) {
        const Model model = read_model(path);
        for (const Format& format : formats) {
            SCOPED_TRACE(path + " as " + format.extension);
            expect_it_comes_back(model, format);
            SCOPED_TRACE("posed");
            if (!model.clips.empty())
                expect_it_comes_back(posed_model(model, &model.clips.front()), format);
            SCOPED_TRACE("with morph targets");
            if (format.extension == ".glb") expect_it_comes_back(with_targets(model), format);
        }
    }
}

TEST(SampleModels, ComeBackFromEveryFormatThatIsWritten)
{
    expect_all_come_back(std::string(TRIVAR_BINARY_DIR) + "/assets/models");
}

TEST(RealDataRoundTrip, EveryModelComesBackFromEveryFormatThatIsWritten)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    for (const char* part : {"/animated", "/cages", "/meshes"}) expect_all_come_back(folder + part);
}

} // namespace
} // namespace trivar
