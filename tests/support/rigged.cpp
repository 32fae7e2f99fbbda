// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/rigged.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::testing {
namespace {

// The binary buffer and the lists that describe it.
struct GltfBytes {
    std::string bytes;
    std::vector<std::string> views, accessors;
    template <class T>
    std::size_t add(const std::vector<T>& values, int component, const std::string& type)
    {
        views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})",
                                    bytes.size(), values.size() * sizeof(T)));
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        accessors.push_back(
            fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"}})",
                        views.size() - 1, component, values.size(), type));
        return accessors.size() - 1;
    }
    template <class T> std::size_t floats(const std::vector<T>& values, const std::string& type)
    {
        return add(values, 5126, type);
    }
};

std::string list(const std::vector<std::string>& items)
{
    return fmt::format("[{}]", fmt::join(items, ","));
}

std::string mesh_text(const Mesh& mesh, GltfBytes& out)
{
    std::vector<std::array<std::uint16_t, 4>> joints;
    std::vector<glm::vec4> weights;
    for (const Mesh::Influences& by : mesh.influences) {
        joints.push_back(by.joints);
        weights.push_back(by.weights);
    }
    std::vector<std::uint32_t> corners;
    for (const glm::uvec3& t : triangles(mesh))
        for (int k = 0; k < 3; ++k) corners.push_back(t[k]);
    std::vector<std::string> targets;
    for (const Mesh::MorphTarget& target : mesh.morph_targets)
        targets.push_back(fmt::format(R"({{"POSITION":{},"NORMAL":{}}})",
                                      out.floats(target.positions, "VEC3"),
                                      out.floats(target.normals, "VEC3")));
    return fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{},"TANGENT":{},)"
                       R"("JOINTS_0":{},"WEIGHTS_0":{}}},"indices":{},"targets":{}}}]}})",
                       out.floats(mesh.positions, "VEC3"), out.floats(mesh.normals, "VEC3"),
                       out.floats(mesh.tangents, "VEC4"), out.add(joints, 5123, "VEC4"),
                       out.floats(weights, "VEC4"), out.add(corners, 5125, "SCALAR"),
                       list(targets));
}

std::string node_text(const Model& model, std::size_t index)
{
    const Node& node = model.nodes[index];
    std::vector<std::size_t> children;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (model.nodes[i].parent == static_cast<int>(index)) children.push_back(i);
    const glm::dvec3& t = node.rest.translation;
    std::string text =
        fmt::format(R"({{"name":"{}","translation":[{},{},{}])", node.name, t.x, t.y, t.z);
    if (node.mesh >= 0) text += fmt::format(R"(,"mesh":{})", node.mesh);
    if (node.skin >= 0) text += fmt::format(R"(,"skin":{})", node.skin);
    if (!children.empty()) text += fmt::format(R"(,"children":[{}])", fmt::join(children, ","));
    return text + "}";
}

std::string clip_text(const Clip& clip, GltfBytes& out)
{
    std::vector<std::string> samplers, channels;
    for (const Channel& c : clip.channels) {
        std::vector<glm::vec4> rotations;
        for (std::size_t i = 0; c.of == Channel::Of::rotation && i < c.values.size(); i += 4)
            rotations.emplace_back(c.values[i], c.values[i + 1], c.values[i + 2], c.values[i + 3]);
        samplers.push_back(fmt::format(
            R"({{"input":{},"output":{},"interpolation":"{}"}})", out.floats(c.times_s, "SCALAR"),
            rotations.empty() ? out.floats(c.values, "SCALAR") : out.floats(rotations, "VEC4"),
            c.interpolation == Channel::Interpolation::cubic  ? "CUBICSPLINE"
            : c.interpolation == Channel::Interpolation::step ? "STEP"
                                                              : "LINEAR"));
        channels.push_back(fmt::format(R"({{"sampler":{},"target":{{"node":{},"path":"{}"}}}})",
                                       samplers.size() - 1, c.node,
                                       c.of == Channel::Of::rotation ? "rotation" : "weights"));
    }
    return fmt::format(R"({{"name":"{}","samplers":{},"channels":{}}})", clip.name, list(samplers),
                       list(channels));
}

Mesh bar()
{
    Mesh mesh;
    constexpr int rings = 17;
    Mesh::MorphTarget thicker;
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < 4; ++side)
            for (int end = 0; end < 2; ++end) {
                const float x = 4 * static_cast<float>(ring) / (rings - 1);
                const float angle = glm::radians(90.0f * static_cast<float>(side));
                const glm::vec3 n(0, std::cos(angle), std::sin(angle)), along(0, -n.z, n.y);
                const float width = std::max(0.0f, 1 - std::abs(x - 2));
                mesh.positions.push_back(glm::vec3(x, 0, 0) + n * 0.5f +
                                         along * (end == 0 ? -0.5f : 0.5f));
                mesh.normals.push_back(n);
                mesh.tangents.emplace_back(1, 0, 0, 1);
                thicker.positions.push_back(
                    width * glm::vec3(0, mesh.positions.back().y, mesh.positions.back().z));
                thicker.normals.push_back(width * glm::vec3(0.3f, 0, 0));
                const float tip = glm::clamp((x - 1) / 2, 0.0f, 1.0f);
                mesh.influences.push_back({{0, 1, 0, 0}, {1 - tip, tip, 0, 0}});
            }
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (std::uint32_t side = 0; side < 4; ++side) {
            const std::uint32_t a = 8 * ring + 2 * side, b = a + 8;
            add_face(mesh, std::array{a, b, b + 1});
            add_face(mesh, std::array{a, b + 1, a + 1});
        }
    mesh.morph_targets = {std::move(thicker)};
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

} // namespace

std::string base64(const std::string& bytes)
{
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word =
                word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
    }
    return text;
}

Model rigged_model()
{
    Model model = single_mesh_model("bar", bar());
    model.nodes[0].skin = 0;
    model.nodes.push_back({"root"});
    model.nodes.push_back({"tip", 1, glm::translate(glm::dmat4(1), {2, 0, 0})});
    model.nodes[2].rest.translation = {2, 0, 0};
    model.skins = {{{1, 2}, {glm::dmat4(1), glm::translate(glm::dmat4(1), {-2, 0, 0})}}};
    const float half = std::sqrt(0.5f);
    model.clips = {
        {"bend",
         {{2,
           Channel::Of::rotation,
           Channel::Interpolation::linear,
           {0, 1},
           {0, 0, 0, 1, 0, 0, half, half},
           4}},
         0,
         1},
        {"swell",
         {{0, Channel::Of::morph_weights, Channel::Interpolation::linear, {0, 1}, {0, 1}, 1}},
         0,
         1}};
    return model;
}

std::string gltf_text(const Model& model)
{
    GltfBytes out;
    const std::string mesh = mesh_text(*model.meshes.front(), out);
    std::vector<std::string> nodes, skins, clips, roots;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        nodes.push_back(node_text(model, i));
        if (model.nodes[i].parent < 0) roots.push_back(std::to_string(i));
    }
    for (const Skin& skin : model.skins) {
        std::vector<glm::mat4> matrices(skin.mesh_to_joint.begin(), skin.mesh_to_joint.end());
        skins.push_back(fmt::format(R"({{"joints":[{}],"inverseBindMatrices":{}}})",
                                    fmt::join(skin.joints, ","), out.floats(matrices, "MAT4")));
    }
    for (const Clip& clip : model.clips) clips.push_back(clip_text(clip, out));
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":{}}}],"nodes":{},"meshes":[{}],)"
        R"("skins":{},"animations":{},"accessors":{},"bufferViews":{},"buffers":[{{"byteLength":{},)"
        R"("uri":"data:application/octet-stream;base64,{}"}}]}})",
        list(roots), list(nodes), mesh, list(skins), list(clips), list(out.accessors),
        list(out.views), out.bytes.size(), base64(out.bytes));
}

} // namespace trivar::testing
