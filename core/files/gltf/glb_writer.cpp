// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/formats.h"
#include "core/files/gltf/glb_accessors.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/gltf/glb_materials.h"
#include "core/files/gltf/repeated_nodes.h"
#include "core/mesh/node_parts.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

using Json = GlbEntries;

class GlbWriter {
public:
    GlbWriter(const Model& model, GlbOptions options) : model_(model), options_(options) {}

    std::string write()
    {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Trivar"}};
        materials_.add_all();
        skinned_.resize(model_.meshes.size());
        for (const Node& node : model_.nodes)
            if (node.mesh >= 0 && node.skin >= 0) skinned_[static_cast<std::size_t>(node.mesh)] = 1;
        number_nodes();
        const std::vector<int> mesh_index = write_meshes();
        std::vector<int> curves_index;
        for (const Ref<Curves>& curves : model_.curves)
            curves_index.push_back(write_curves(*curves));
        write_nodes(mesh_index, curves_index);
        for (const Camera& camera : model_.cameras) json_["cameras"].push_back(written(camera));
        for (const Skin& skin : model_.skins) write_skin(skin);
        for (const Clip& clip : model_.clips) write_clip(clip);
        if (!model_.extras.empty()) json_["extras"] = Json::parse(model_.extras);
        // Without it a viewer would show one tile in place of all.
        for (const char* list : {"extensionsRequired", "extensionsUsed"})
            if (!groups_.empty()) json_[list].push_back(instancing);
        if (materials_.emissive_strength())
            json_["extensionsUsed"].push_back("KHR_materials_emissive_strength");
        return container();
    }

private:
    static constexpr const char* instancing = "EXT_mesh_gpu_instancing";

    // Numbers the nodes as the file has them: those of a group are one.
    void number_nodes()
    {
        if (options_.instances) groups_ = repeated_nodes(model_);
        constexpr std::size_t none = static_cast<std::size_t>(-1);
        group_of_.assign(model_.nodes.size(), none);
        for (std::size_t g = 0; g < groups_.size(); ++g)
            for (const int n : groups_[g]) group_of_[static_cast<std::size_t>(n)] = g;
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            const bool repeats =
                group_of_[n] != none && static_cast<std::size_t>(groups_[group_of_[n]][0]) != n;
            number_.push_back(repeats ? none : node_count_++);
        }
    }
    std::size_t number(int node) const { return number_[static_cast<std::size_t>(node)]; }
    bool repeats(std::size_t node) const { return number_[node] == static_cast<std::size_t>(-1); }

    // Writes the meshes; of equal ones the first where there are instances. Returns where they are.
    std::vector<int> write_meshes()
    {
        std::vector<int> out;
        std::map<std::pair<const Mesh*, bool>, int> known; // looked up only
        for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
            const Ref<Mesh>& mesh = model_.meshes[m];
            const std::pair key{mesh.get(), skinned_[m] != 0};
            if (const auto at = known.find(key); options_.instances && at != known.end())
                out.push_back(at->second);
            else
                out.push_back(known[key] = write_mesh(*mesh, key.second));
        }
        return out;
    }

    int add_indices(const std::vector<std::uint32_t>& indices)
    {
        const int view =
            out_.add_view(indices.data(), indices.size() * 4, GlbAccessors::element_array_buffer);
        json_["accessors"].push_back({{"bufferView", view},
                                      {"componentType", GlbAccessors::uint32},
                                      {"count", indices.size()},
                                      {"type", "SCALAR"}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    Json targets(const Mesh& mesh)
    {
        Json out = Json::array();
        for (const Mesh::MorphTarget& target : mesh.morph_targets) {
            Json written = Json::object();
            if (!target.positions.empty())
                written["POSITION"] = out_.add_differences(target.positions);
            if (!target.normals.empty() && !mesh.normals.empty())
                written["NORMAL"] = out_.add_differences(target.normals);
            if (!target.tangents.empty() && !mesh.tangents.empty())
                written["TANGENT"] = out_.add_differences(target.tangents);
            out.push_back(std::move(written));
        }
        return out;
    }

    void add_influences(Json& attributes, const Mesh& mesh)
    {
        std::vector<std::array<std::uint16_t, 4>> joints;
        std::vector<glm::vec4> weights;
        for (const Mesh::Influences& each : mesh.influences) {
            joints.push_back(each.joints);
            for (int k = 0; k < 4; ++k) // without a weight no joint is named
                if (each.weights[k] == 0) joints.back()[static_cast<std::size_t>(k)] = 0;
            weights.push_back(each.weights);
        }
        attributes["JOINTS_0"] =
            out_.add(joints, "VEC4", GlbAccessors::array_buffer, GlbAccessors::uint16);
        attributes["WEIGHTS_0"] = out_.add(weights, "VEC4");
    }

    void write_skin(const Skin& skin)
    {
        std::vector<glm::mat4> matrices(skin.mesh_to_joint.begin(), skin.mesh_to_joint.end());
        Json written{{"joints", Json::array()}};
        for (const int joint : skin.joints) written["joints"].push_back(number(joint));
        if (!matrices.empty()) written["inverseBindMatrices"] = out_.add(matrices, "MAT4", 0);
        json_["skins"].push_back(std::move(written));
    }

    // Adds an accessor once per use and content: many channels share their times, and channels of
    // morph targets their weights. Times and weights are never one, even if they are equal.
    int shared_accessor(const char* use, const std::vector<float>& values, const char* type,
                        std::size_t components)
    {
        const auto [known, fresh] = shared_.try_emplace({use, values}, 0);
        if (!fresh) return known->second;
        known->second = out_.add(values, type, 0);
        json_["accessors"].back()["count"] = values.size() / components;
        return known->second;
    }

    void write_clip(const Clip& clip)
    {
        static constexpr std::array paths{"translation", "rotation", "scale", "weights"};
        static constexpr std::array types{"VEC3", "VEC4", "VEC3", "SCALAR"};
        static constexpr std::array ways{"STEP", "LINEAR", "CUBICSPLINE"};
        Json channels = Json::array(), samplers = Json::array();
        for (const Channel& channel : clip.channels) {
            const auto of = static_cast<std::size_t>(channel.of);
            const bool weights = channel.of == Channel::Of::morph_weights;
            const int times = shared_accessor("times", channel.times_s, "SCALAR", 1);
            json_["accessors"][static_cast<std::size_t>(times)]["min"] = {
                plain(channel.times_s.front())};
            json_["accessors"][static_cast<std::size_t>(times)]["max"] = {
                plain(channel.times_s.back())};
            channels.push_back({{"sampler", samplers.size()},
                                {"target", {{"node", number(channel.node)}, {"path", paths[of]}}}});
            samplers.push_back(
                {{"input", times},
                 {"output", shared_accessor(paths[of], channel.values, types[of],
                                            weights ? 1 : channel.components)},
                 {"interpolation", ways[static_cast<std::size_t>(channel.interpolation)]}});
        }
        if (channels.empty()) return;
        Json written;
        if (!clip.name.empty()) written["name"] = clip.name;
        written["channels"] = std::move(channels);
        written["samplers"] = std::move(samplers);
        json_["animations"].push_back(std::move(written));
    }

    // Writes one primitive per material, all on the same vertices. Returns -1 if there are no
    // faces.
    int write_mesh(const Mesh& mesh, bool skinned)
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
        Json shared = out_.attributes(mesh);
        if (skinned && !mesh.influences.empty()) add_influences(shared, mesh);
        const Json all_targets = targets(mesh);
        Json primitives = Json::array();
        for (const auto& [material, indices] : by_material) {
            Json primitive{{"attributes", shared}, {"indices", add_indices(indices)}};
            if (material < model_.materials.size())
                primitive["material"] = materials_.on(material, mesh.uvs.size());
            if (!all_targets.empty()) primitive["targets"] = all_targets;
            primitives.push_back(std::move(primitive));
        }
        json_["meshes"].push_back({{"primitives", std::move(primitives)}});
        return static_cast<int>(json_["meshes"].size()) - 1;
    }

    // Writes the lines. Returns -1 if there are none.
    int write_curves(const Curves& curves)
    {
        Json primitives = curve_primitives(out_, curves, model_.materials.size());
        if (primitives.empty()) return -1;
        for (Json& primitive : primitives)
            if (primitive.contains("material"))
                primitive["material"] = materials_.on(primitive["material"], 0);
        json_["meshes"].push_back({{"primitives", std::move(primitives)}});
        return static_cast<int>(json_["meshes"].size()) - 1;
    }

    static void put_matrix(Json& into, const glm::dmat4& matrix)
    {
        if (matrix == glm::dmat4(1)) return;
        Json values = Json::array();
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) values.push_back(matrix[c][r] + 0.0); // no -0
        into["matrix"] = std::move(values);
    }

    static void put_parts(Json& into, const NodeTransform& p)
    {
        into["translation"] = {p.translation.x, p.translation.y, p.translation.z};
        into["rotation"] = {p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w};
        into["scale"] = {p.scale.x, p.scale.y, p.scale.z};
    }

    void put_instances(Json& into, const glm::dmat4& outside, const std::vector<int>& nodes)
    {
        std::vector<NodeTransform> all;
        for (const int n : nodes)
            all.push_back(*as_parts(model_.nodes[static_cast<std::size_t>(n)].to_parent));
        WrittenInstances written = add_instances(out_, all);
        glm::dmat4 to_middle(1);
        to_middle[3] = glm::dvec4(written.middle, 1);
        put_matrix(into, outside * to_middle);
        into["extensions"][instancing]["attributes"] = std::move(written.attributes);
    }

    // Says which nodes a clip moves: they must be written as translation, rotation and scale.
    std::vector<bool> moved_nodes() const
    {
        std::vector<bool> out(model_.nodes.size());
        for (const Clip& clip : model_.clips)
            for (const Channel& channel : clip.channels)
                if (channel.of != Channel::Of::morph_weights)
                    out[static_cast<std::size_t>(channel.node)] = true;
        return out;
    }

    // Says which nodes exist only for a skinned mesh: their place has no effect, so they become
    // roots without a transform.
    std::vector<bool> placeless_nodes(const std::vector<bool>& moved) const
    {
        std::vector<bool> out;
        for (std::size_t n = 0; n < model_.nodes.size(); ++n)
            out.push_back(model_.nodes[n].skin >= 0 && model_.nodes[n].mesh >= 0 && !moved[n]);
        for (const Node& node : model_.nodes)
            if (node.parent >= 0) out[static_cast<std::size_t>(node.parent)] = false;
        for (const Skin& skin : model_.skins)
            for (const int joint : skin.joints) out[static_cast<std::size_t>(joint)] = false;
        return out;
    }

    void name_mesh(int mesh, const std::string& name)
    {
        Json& target = json_["meshes"][static_cast<std::size_t>(mesh)];
        if (!target.contains("name") && !name.empty()) target["name"] = name;
    }

    void write_nodes(const std::vector<int>& mesh_index, const std::vector<int>& curves_index)
    {
        const glm::dmat4 z_to_y({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
        const std::vector<bool> moved = moved_nodes(), placeless = placeless_nodes(moved);
        Json nodes = Json::array(), holders = Json::array(), roots = Json::array();
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            if (repeats(n)) continue;
            const Node& node = model_.nodes[n];
            Json written;
            if (!node.name.empty()) written["name"] = node.name;
            const glm::dmat4 outside = node.parent < 0 ? z_to_y : glm::dmat4(1);
            std::size_t top = number_[n]; // child of the parent
            if (moved[n]) {
                put_parts(written, node.rest);
                if (const glm::dmat4 outer = outside * node.outer; outer != glm::dmat4(1)) {
                    Json holder{{"children", Json::array({number_[n]})}};
                    put_matrix(holder, outer);
                    top = node_count_ + holders.size();
                    holders.push_back(std::move(holder));
                }
            } else if (group_of_[n] < groups_.size()) {
                put_instances(written, outside, groups_[group_of_[n]]);
            } else if (!placeless[n]) {
                put_matrix(written, outside * node.to_parent);
            }
            const int mesh =
                node.mesh < 0 ? -1 : mesh_index.at(static_cast<std::size_t>(node.mesh));
            if (mesh >= 0) {
                written["mesh"] = mesh;
                if (skinned_[static_cast<std::size_t>(node.mesh)] != 0 && node.skin >= 0)
                    written["skin"] = node.skin;
                if (!node.morph_weights.empty()) {
                    Json weights = Json::array();
                    for (const float weight : node.morph_weights) weights.push_back(plain(weight));
                    written["weights"] = std::move(weights);
                }
                name_mesh(mesh, node.name);
            }
            if (node.camera >= 0) written["camera"] = node.camera;
            const int curves =
                node.curves < 0 ? -1 : curves_index.at(static_cast<std::size_t>(node.curves));
            if (curves >= 0) name_mesh(curves, node.name);
            if (curves >= 0 && mesh < 0) written["mesh"] = curves;
            if (curves >= 0 && mesh >= 0) { // a node shows one mesh, which may have targets
                written["children"] = Json::array({node_count_ + holders.size()});
                Json child{{"mesh", curves}};
                if (!node.name.empty()) child["name"] = node.name;
                holders.push_back(std::move(child));
            }
            if (written.is_null()) written = Json::object();
            nodes.push_back(std::move(written));
            if (node.parent < 0 || placeless[n])
                roots.push_back(top);
            else
                nodes[number(node.parent)]["children"].push_back(top);
        }
        if (nodes.empty()) return;
        for (Json& holder : holders) nodes.push_back(std::move(holder));
        json_["nodes"] = std::move(nodes);
        json_["scenes"] = {{{"nodes", std::move(roots)}}};
        json_["scene"] = 0;
    }

    static Json written(const Camera& camera)
    {
        const double aspect = camera.size_px.x / camera.size_px.y;
        const double away = std::max(glm::distance(camera.eye, camera.target), 1e-3);
        const double near = away / 1000, far = away * 1000, half = camera.height_world / 2;
        if (camera.perspective)
            return {{"type", "perspective"},
                    {"perspective",
                     {{"aspectRatio", aspect},
                      {"yfov", camera.fov_y},
                      {"znear", near},
                      {"zfar", far}}}};
        return {{"type", "orthographic"},
                {"orthographic",
                 {{"xmag", half * aspect}, {"ymag", half}, {"znear", near}, {"zfar", far}}}};
    }

    std::string container()
    {
        binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
        if (!binary_.empty()) json_["buffers"] = {{{"byteLength", binary_.size()}}};
        // Names that are not UTF-8 must not make the file unwritable.
        return glb_container(
            {json_.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(binary_)});
    }

    const Model& model_;
    GlbOptions options_;
    std::vector<std::vector<int>> groups_; // nodes that are written as instances
    // Each node's group, and its number in the file; none: another node of its group has it.
    std::vector<std::size_t> group_of_, number_;
    std::size_t node_count_ = 0; // in the file, before the holders
    GlbAccessors out_;
    Json& json_ = out_.json;
    std::string& binary_ = out_.binary;
    GlbMaterials materials_{model_.materials, out_};
    std::vector<char> skinned_; // by mesh: a node has a skin for it
    std::map<std::pair<std::string, std::vector<float>>, int> shared_; // accessors by content
};

} // namespace

std::string write_glb(const Model& model, GlbOptions options)
{
    return GlbWriter(model, options).write();
}

} // namespace trivar
