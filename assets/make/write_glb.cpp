// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/write_model.h"

#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>
#include <tuple>
#include <unistd.h>

namespace make {

namespace {

enum ComponentType {
    unsigned_byte = 5121,
    unsigned_short = 5123,
    unsigned_int = 5125,
    real = 5126
};
enum Target { any = 0, vertices = 34962, indices = 34963 };

std::string number(double value, int digits = 6)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string array(std::initializer_list<float> values, int digits = 6)
{
    std::string text = "[";
    for (float v : values) text += (text.size() > 1 ? "," : "") + number(double(v), digits);
    return text + "]";
}

// Bounds, which must be the very floats.
std::string min_and_max(std::initializer_list<float> lo, std::initializer_list<float> hi)
{
    constexpr int exact = 9;
    return ",\"min\":" + array(lo, exact) + ",\"max\":" + array(hi, exact);
}

// A JSON list that grows by one item at a time.
struct List {
    std::string text;
    int count = 0;
    int add(const std::string& item)
    {
        text += (count ? "," : "") + item;
        return count++;
    }
};

// The binary chunk with the views and accessors that describe it.
struct Buffer {
    std::string bytes;
    List views, accessors;

    int add_view(const char* data, std::size_t length, Target target)
    {
        const std::size_t begin = bytes.size();
        bytes.append(data, length);
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        return views.add("{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                         ",\"byteLength\":" + std::to_string(length) +
                         (target ? ",\"target\":" + std::to_string(target) : "") + "}");
    }

    template <class T>
    int add(const std::vector<T>& values, ComponentType component, const char* type, Target target,
            const std::string& more = "")
    {
        const int view = add_view(reinterpret_cast<const char*>(values.data()),
                                  values.size() * sizeof(T), target);
        return accessors.add("{\"bufferView\":" + std::to_string(view) +
                             ",\"componentType\":" + std::to_string(component) +
                             ",\"count\":" + std::to_string(values.size()) + ",\"type\":\"" + type +
                             "\"" + more + "}");
    }
};

// A mesh as a GPU wants it: points split where their texture coordinates differ.
struct Split {
    std::vector<vec3> positions, normals;
    std::vector<vec2> uvs;
    std::vector<std::array<std::uint8_t, 4>> colors;
    std::vector<std::uint32_t> triangles;
};

std::array<std::uint8_t, 4> color_bytes(vec3 srgb)
{
    const vec3 k = linear_light(srgb) * 255.f + .5f;
    return {std::uint8_t(k.x), std::uint8_t(k.y), std::uint8_t(k.z), 255};
}

Split split(const Mesh& mesh)
{
    Split out;
    const std::vector<vec3> normal = normals(mesh);
    std::map<std::tuple<int, long, long>, std::uint32_t> seen;
    const auto corner = [&](std::size_t face, std::size_t k) {
        const int point = mesh.faces[face][k];
        const vec2 uv = mesh.uvs.empty() ? vec2(0) : mesh.uvs[face][k];
        const std::tuple key(point, std::lround(uv.x * 65536), std::lround(uv.y * 65536));
        const auto [it, fresh] = seen.try_emplace(key, std::uint32_t(out.positions.size()));
        if (fresh) {
            const auto p = std::size_t(point);
            out.positions.push_back(mesh.points[p]);
            out.normals.push_back(normal[p]);
            out.uvs.push_back(uv);
            if (!mesh.colors.empty()) out.colors.push_back(color_bytes(mesh.colors[p]));
        }
        return it->second;
    };
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Face& q = mesh.faces[f];
        const std::uint32_t a = corner(f, 0), b = corner(f, 1), c = corner(f, 2);
        if (q[3] < 0) {
            out.triangles.insert(out.triangles.end(), {a, b, c});
            continue;
        }
        const std::uint32_t d = corner(f, 3);
        const auto length = [&](std::size_t i, std::size_t j) {
            return glm::distance(mesh.points[std::size_t(q[i])], mesh.points[std::size_t(q[j])]);
        };
        if (length(1, 3) < length(0, 2)) {
            out.triangles.insert(out.triangles.end(), {a, b, d, b, c, d});
        } else {
            out.triangles.insert(out.triangles.end(), {a, b, c, a, c, d});
        }
    }
    return out;
}

std::string primitive(const Mesh& mesh, const Skin& skin, Buffer& buffer)
{
    const Split s = split(mesh);
    vec3 lo(1e9f), hi(-1e9f);
    for (const vec3& p : s.positions) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    const std::string bounds = min_and_max({lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z});
    List attributes;
    const auto attribute = [&](const char* name, int accessor) {
        attributes.add("\"" + std::string(name) + "\":" + std::to_string(accessor));
    };
    attribute("POSITION", buffer.add(s.positions, real, "VEC3", vertices, bounds));
    attribute("NORMAL", buffer.add(s.normals, real, "VEC3", vertices));
    if (!mesh.uvs.empty()) attribute("TEXCOORD_0", buffer.add(s.uvs, real, "VEC2", vertices));
    if (!s.colors.empty()) {
        attribute("COLOR_0",
                  buffer.add(s.colors, unsigned_byte, "VEC4", vertices, ",\"normalized\":true"));
    }
    if (!skin.joints.empty()) {
        std::vector<std::array<std::uint8_t, 4>> joints;
        std::vector<vec4> weights;
        for (const vec3& p : s.positions) {
            const Influence influence = skin.at(p);
            joints.push_back(influence.joints);
            weights.push_back(influence.weights);
        }
        attribute("JOINTS_0", buffer.add(joints, unsigned_byte, "VEC4", vertices));
        attribute("WEIGHTS_0", buffer.add(weights, real, "VEC4", vertices));
    }
    int triangles = 0;
    if (s.positions.size() < 65535) {
        const std::vector<std::uint16_t> small(s.triangles.begin(), s.triangles.end());
        triangles = buffer.add(small, unsigned_short, "SCALAR", indices);
    } else {
        triangles = buffer.add(s.triangles, unsigned_int, "SCALAR", indices);
    }
    return "{\"attributes\":{" + attributes.text + "},\"indices\":" + std::to_string(triangles) +
           ",\"material\":" + std::to_string(mesh.material) + "}";
}

std::string mesh_json(const Node& node, const Skin& skin, Buffer& buffer)
{
    std::map<int, Mesh> by_material;
    for (const Mesh& part : node.parts) by_material[part.material].add(part).mat(part.material);
    List primitives;
    for (const auto& [material, mesh] : by_material) primitives.add(primitive(mesh, skin, buffer));
    return "{\"name\":\"" + node.name + "\",\"primitives\":[" + primitives.text + "]}";
}

std::string children(const Model& model, int parent)
{
    List kids;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].parent == parent) kids.add(std::to_string(i));
    }
    return kids.text;
}

std::string node_json(const Model& model, int index, int mesh)
{
    const Node& n = model.nodes[std::size_t(index)];
    std::string text = "{\"name\":\"" + n.name + "\"";
    if (n.translation != vec3(0)) {
        text += ",\"translation\":" + array({n.translation.x, n.translation.y, n.translation.z});
    }
    if (n.rotation != quat(1, 0, 0, 0)) {
        text += ",\"rotation\":" + array({n.rotation.x, n.rotation.y, n.rotation.z, n.rotation.w});
    }
    if (mesh >= 0) text += ",\"mesh\":" + std::to_string(mesh);
    if (index == 0 && !model.skin.joints.empty()) text += ",\"skin\":0";
    if (const std::string kids = children(model, index); !kids.empty()) {
        text += ",\"children\":[" + kids + "]";
    }
    if (index == 0 && !model.extras.empty()) {
        List extras;
        for (const auto& [key, value] : model.extras) extras.add("\"" + key + "\":" + value);
        text += ",\"extras\":{" + extras.text + "}";
    }
    return text + "}";
}

std::string skin_json(const Model& model, Buffer& buffer)
{
    const std::vector<mat4> to_world = world_matrices(model);
    List joints;
    std::vector<mat4> matrices;
    for (const int joint : model.skin.joints) {
        joints.add(std::to_string(joint));
        matrices.push_back(glm::inverse(to_world[std::size_t(joint)]));
    }
    return "{\"joints\":[" + joints.text +
           "],\"inverseBindMatrices\":" + std::to_string(buffer.add(matrices, real, "MAT4", any)) +
           "}";
}

std::string clip_json(const Clip& clip, Buffer& buffer)
{
    const std::string bounds = min_and_max({clip.times_s.front()}, {clip.times_s.back()});
    const int times = buffer.add(clip.times_s, real, "SCALAR", any, bounds);
    List samplers, channels;
    for (const Channel& c : clip.channels) {
        const bool moves = !c.translations.empty();
        std::vector<vec4> turns;
        for (const quat& r : c.rotations) turns.emplace_back(r.x, r.y, r.z, r.w);
        const int values = moves ? buffer.add(c.translations, real, "VEC3", any)
                                 : buffer.add(turns, real, "VEC4", any);
        const int sampler = samplers.add("{\"input\":" + std::to_string(times) + ",\"output\":" +
                                         std::to_string(values) + ",\"interpolation\":\"LINEAR\"}");
        channels.add("{\"sampler\":" + std::to_string(sampler) +
                     ",\"target\":{\"node\":" + std::to_string(c.node) + ",\"path\":\"" +
                     (moves ? "translation" : "rotation") + "\"}}");
    }
    return "{\"name\":\"" + clip.name + "\",\"samplers\":[" + samplers.text + "],\"channels\":[" +
           channels.text + "]}";
}

std::string material_json(const Material& m, List& images, Buffer& buffer)
{
    const vec3 k = linear_light(m.color);
    std::string texture, glow;
    if (m.glow > 0) {
        const float factor = std::min(1.f, m.glow);
        const vec3 light = factor * k;
        glow = ",\"emissiveFactor\":" + array({light.x, light.y, light.z});
        if (m.glow > 1)
            glow += ",\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":" +
                    number(double(m.glow)) + "}}";
    }
    if (!m.texture.rgb.empty()) {
        const std::string bytes = png(m.texture);
        const int view = buffer.add_view(bytes.data(), bytes.size(), any);
        const int image =
            images.add("{\"name\":\"" + m.name + "\",\"bufferView\":" + std::to_string(view) +
                       ",\"mimeType\":\"image/png\"}");
        texture = ",\"baseColorTexture\":{\"index\":" + std::to_string(image) + "}";
        if (m.glow > 0) glow += ",\"emissiveTexture\":{\"index\":" + std::to_string(image) + "}";
    }
    return "{\"name\":\"" + m.name +
           "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":" + array({k.x, k.y, k.z, m.alpha}) +
           texture + ",\"metallicFactor\":" + number(double(m.metal)) +
           ",\"roughnessFactor\":" + number(double(m.rough)) + "}" + glow +
           (m.alpha < 1 ? ",\"alphaMode\":\"BLEND\"}" : "}");
}

// One texture an image, in the same order.
std::string textures_json(const List& images)
{
    List textures;
    for (int i = 0; i < images.count; ++i) textures.add("{\"source\":" + std::to_string(i) + "}");
    return ",\"images\":[" + images.text + "],\"textures\":[" + textures.text + "]";
}

std::string little_endian(std::size_t value)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(char(value >> shift & 255));
    return bytes;
}

} // namespace

void write_glb(const Model& model, const std::string& path)
{
    Buffer buffer;
    List meshes, nodes, materials, images, clips;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        const int mesh = node.parts.empty()
                             ? -1
                             : meshes.add(mesh_json(node, i == 0 ? model.skin : Skin{}, buffer));
        nodes.add(node_json(model, int(i), mesh));
    }
    for (const Material& m : model.materials) materials.add(material_json(m, images, buffer));
    const std::string skin = model.skin.joints.empty() ? "" : skin_json(model, buffer);
    for (const Clip& c : model.clips) clips.add(clip_json(c, buffer));

    const bool glows =
        std::ranges::any_of(model.materials, [](const Material& m) { return m.glow > 1; });
    std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"trivar-make\"},\"scene\":0,"
                       "\"scenes\":[{\"nodes\":[" +
                       children(model, -1) + "]}],\"nodes\":[" + nodes.text + "],\"meshes\":[" +
                       meshes.text + "],\"materials\":[" + materials.text + "]";
    if (glows) json += ",\"extensionsUsed\":[\"KHR_materials_emissive_strength\"]";
    if (images.count) json += textures_json(images);
    if (!skin.empty()) json += ",\"skins\":[" + skin + "]";
    if (clips.count) json += ",\"animations\":[" + clips.text + "]";
    json += ",\"accessors\":[" + buffer.accessors.text + "],\"bufferViews\":[" + buffer.views.text +
            "],\"buffers\":[{\"byteLength\":" + std::to_string(buffer.bytes.size()) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');

    constexpr std::size_t header = 12, chunk_header = 8;
    // Whoever reads the file meanwhile has the one before, or none.
    const std::string beside = path + "." + std::to_string(::getpid()) + ".part";
    std::ofstream file(beside, std::ios::binary);
    file << "glTF" << little_endian(2)
         << little_endian(header + 2 * chunk_header + json.size() + buffer.bytes.size())
         << little_endian(json.size()) << "JSON" << json << little_endian(buffer.bytes.size())
         << std::string("BIN\0", 4) << buffer.bytes;
    file.close();
    if (!file || std::rename(beside.c_str(), path.c_str()) != 0)
        throw std::runtime_error("cannot write " + path);
}

} // namespace make
