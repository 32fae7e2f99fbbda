// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/files/formats.h"
#include "core/files/glb_chunks.h"
#include "core/files/image.h"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using Json = nlohmann::ordered_json;

enum : int { array_buffer = 34962, element_array_buffer = 34963, float32 = 5126, uint32 = 5125 };

// The double whose shortest text is the float's: 0.1, not 0.10000000149011612.
double plain(float value)
{
    return parse_number(shortest(value)).value();
}

class GlbWriter {
public:
    explicit GlbWriter(const Model& model) : model_(model) {}

    std::string write()
    {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Trivar"}};
        for (const Material& material : model_.materials) {
            Json entry = written(material); // adds to other lists, so the list is looked up after
            json_["materials"].push_back(std::move(entry));
        }
        std::vector<int> mesh_index;
        for (const Ref<Mesh>& mesh : model_.meshes) mesh_index.push_back(write_mesh(*mesh));
        write_nodes(mesh_index);
        if (!model_.extras.empty()) json_["extras"] = Json::parse(model_.extras);
        if (emissive_strength_) json_["extensionsUsed"] = {"KHR_materials_emissive_strength"};
        return container();
    }

private:
    // Appends bytes at a multiple of four; returns the index of their view.
    int add_view(const void* data, std::size_t size, int target)
    {
        binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
        Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
        if (target != 0) view["target"] = target;
        binary_.append(static_cast<const char*>(data), size);
        json_["bufferViews"].push_back(std::move(view));
        return static_cast<int>(json_["bufferViews"].size()) - 1;
    }

    template <class T> int add_accessor(const std::vector<T>& values, const char* type)
    {
        Json accessor{
            {"bufferView", add_view(values.data(), values.size() * sizeof(T), array_buffer)},
            {"componentType", float32},
            {"count", values.size()},
            {"type", type}};
        json_["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    int add_indices(const std::vector<std::uint32_t>& indices)
    {
        const int view = add_view(indices.data(), indices.size() * 4, element_array_buffer);
        json_["accessors"].push_back({{"bufferView", view},
                                      {"componentType", uint32},
                                      {"count", indices.size()},
                                      {"type", "SCALAR"}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    Json attributes(const Mesh& mesh)
    {
        Json result;
        const int positions = add_accessor(mesh.positions, "VEC3");
        glm::vec3 lo(std::numeric_limits<float>::max()), hi = -lo;
        for (const glm::vec3& p : mesh.positions) lo = glm::min(lo, p), hi = glm::max(hi, p);
        json_["accessors"].back()["min"] = {plain(lo.x), plain(lo.y), plain(lo.z)};
        json_["accessors"].back()["max"] = {plain(hi.x), plain(hi.y), plain(hi.z)};
        result["POSITION"] = positions;
        if (!mesh.normals.empty()) result["NORMAL"] = add_accessor(mesh.normals, "VEC3");
        if (!mesh.tangents.empty()) result["TANGENT"] = add_accessor(mesh.tangents, "VEC4");
        if (!mesh.colors.empty()) {
            std::vector<glm::vec4> colors = mesh.colors;
            for (glm::vec4& color : colors) color = glm::clamp(color, 0.0f, 1.0f);
            result["COLOR_0"] = add_accessor(colors, "VEC4");
        }
        for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
            std::vector<glm::vec2> uvs = mesh.uvs[set];
            for (glm::vec2& uv : uvs) uv.y = 1 - uv.y; // glTF's v goes down
            result["TEXCOORD_" + std::to_string(set)] = add_accessor(uvs, "VEC2");
        }
        return result;
    }

    // One primitive a material, all on the same vertices. -1 where there is no face.
    int write_mesh(const Mesh& mesh)
    {
        const std::vector<glm::uvec3> all = triangles(mesh);
        if (all.empty()) return -1;
        std::map<std::uint32_t, std::vector<std::uint32_t>> by_material;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            auto& indices = by_material[mesh.face_material.empty() ? 0 : mesh.face_material[f]];
            const std::size_t end = mesh.face_begin[f + 1] - 2 * (f + 1);
            for (std::size_t t = mesh.face_begin[f] - 2 * f; t < end; ++t)
                indices.insert(indices.end(), {all[t].x, all[t].y, all[t].z});
        }
        const Json shared = attributes(mesh);
        Json primitives = Json::array();
        for (const auto& [material, indices] : by_material) {
            Json primitive{{"attributes", shared}, {"indices", add_indices(indices)}};
            if (material < model_.materials.size()) primitive["material"] = material;
            primitives.push_back(std::move(primitive));
        }
        json_["meshes"].push_back({{"primitives", std::move(primitives)}});
        return static_cast<int>(json_["meshes"].size()) - 1;
    }

    void write_nodes(const std::vector<int>& mesh_index)
    {
        const glm::dmat4 z_to_y({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
        Json nodes = Json::array(), roots = Json::array();
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            const Node& node = model_.nodes[n];
            Json written;
            if (!node.name.empty()) written["name"] = node.name;
            const glm::dmat4 matrix = node.parent < 0 ? z_to_y * node.to_parent : node.to_parent;
            if (matrix != glm::dmat4(1)) {
                Json values = Json::array();
                for (int c = 0; c < 4; ++c)
                    for (int r = 0; r < 4; ++r) values.push_back(matrix[c][r] + 0.0); // no -0
                written["matrix"] = std::move(values);
            }
            const int mesh =
                node.mesh < 0 ? -1 : mesh_index.at(static_cast<std::size_t>(node.mesh));
            if (mesh >= 0) {
                written["mesh"] = mesh;
                Json& target = json_["meshes"][static_cast<std::size_t>(mesh)];
                if (!target.contains("name") && !node.name.empty()) target["name"] = node.name;
            }
            if (written.is_null()) written = Json::object();
            nodes.push_back(std::move(written));
            if (node.parent < 0)
                roots.push_back(n);
            else
                nodes[static_cast<std::size_t>(node.parent)]["children"].push_back(n);
        }
        if (nodes.empty()) return;
        json_["nodes"] = std::move(nodes);
        json_["scenes"] = {{{"nodes", std::move(roots)}}};
        json_["scene"] = 0;
    }

    Json written(const Material& m)
    {
        Json result;
        if (!m.name.empty()) result["name"] = m.name;
        Json pbr{{"baseColorFactor",
                  {plain(m.base_color.x), plain(m.base_color.y), plain(m.base_color.z),
                   plain(m.base_color.w)}},
                 {"metallicFactor", plain(m.metallic)},
                 {"roughnessFactor", plain(m.roughness)}};
        put_texture(pbr, "baseColorTexture", m.base_color_texture);
        put_texture(pbr, "metallicRoughnessTexture", m.metallic_roughness_texture);
        result["pbrMetallicRoughness"] = std::move(pbr);
        put_texture(result, "normalTexture", m.normal_texture);
        if (m.normal_texture.image && m.normal_scale != 1)
            result["normalTexture"]["scale"] = plain(m.normal_scale);
        put_texture(result, "occlusionTexture", m.occlusion_texture);
        put_texture(result, "emissiveTexture", m.emissive_texture);
        const float strongest = std::max({m.emissive.x, m.emissive.y, m.emissive.z});
        if (strongest > 0) {
            const glm::vec3 color = m.emissive / std::max(strongest, 1.0f);
            result["emissiveFactor"] = {plain(color.x), plain(color.y), plain(color.z)};
        }
        if (strongest > 1) {
            emissive_strength_ = true;
            result["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] =
                plain(strongest);
        }
        if (m.alpha == Material::Alpha::mask) {
            result["alphaMode"] = "MASK";
            result["alphaCutoff"] = plain(m.alpha_cutoff);
        }
        if (m.alpha == Material::Alpha::blend) result["alphaMode"] = "BLEND";
        if (m.double_sided) result["doubleSided"] = true;
        return result;
    }

    void put_texture(Json& into, const char* key, const Texture& texture)
    {
        if (!texture.image) return;
        const int clamp = 33071, repeat = 10497;
        const Json sampler{{"wrapS", texture.repeat_u ? repeat : clamp},
                           {"wrapT", texture.repeat_v ? repeat : clamp}};
        const Json entry{{"sampler", index_of("samplers", sampler)},
                         {"source", image_index(texture.image)}};
        into[key]["index"] = index_of("textures", entry);
        if (texture.uv_set != 0) into[key]["texCoord"] = texture.uv_set;
    }

    // The place of an entry in one of the file's lists, added where it is new.
    std::size_t index_of(const char* list, const Json& entry)
    {
        Json& entries = json_[list];
        const auto at = std::find(entries.begin(), entries.end(), entry);
        if (at != entries.end()) return static_cast<std::size_t>(at - entries.begin());
        entries.push_back(entry);
        return entries.size() - 1;
    }

    std::size_t image_index(const Ref<Image>& image)
    {
        const auto [at, added] = images_.emplace(image.get(), images_.size());
        if (!added) return at->second;
        const bool as_it_came = !image->source_bytes.empty() &&
                                (image->mime == "image/png" || image->mime == "image/jpeg");
        const std::string bytes = as_it_came ? image->source_bytes : encoded_image(*image, ".png");
        Json entry;
        if (!image->name.empty()) entry["name"] = image->name;
        entry["bufferView"] = add_view(bytes.data(), bytes.size(), 0);
        entry["mimeType"] = as_it_came ? image->mime : "image/png";
        json_["images"].push_back(std::move(entry));
        return at->second;
    }

    std::string container()
    {
        binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
        if (!binary_.empty()) json_["buffers"] = {{{"byteLength", binary_.size()}}};
        // Names in other encodings must not make the file unwritable.
        return glb_container(
            {json_.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(binary_)});
    }

    const Model& model_;
    Json json_;
    std::string binary_;
    std::map<const Image*, std::size_t> images_; // looked up only, never walked
    bool emissive_strength_ = false;
};

} // namespace

std::string write_glb(const Model& model)
{
    return GlbWriter(model).write();
}

} // namespace trivar
