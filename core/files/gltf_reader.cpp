// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/formats.h"
#include "core/files/gltf_load.h"
#include "core/files/gltf_materials.h"
#include "core/files/gltf_rig.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <tiny_gltf.h>

namespace trivar {
namespace {

constexpr int max_uv_sets = 8;

class GltfReader {
public:
    GltfReader(const FileText& file, LoadedGltf loaded, const Progress& progress)
        : file_(file),
          gltf_(*loaded.gltf),
          keep_(std::move(loaded.gltf)),
          progress_(progress),
          accessors_(gltf_, file.name),
          rig_(gltf_, accessors_, file.name)
    {
        model_.notices = std::move(loaded.notices);
    }

    Model read()
    {
        report(progress_, 0.2, "Reading materials");
        add_gltf_materials(model_, gltf_, accessors_, file_.name);
        default_material_ = static_cast<std::uint32_t>(model_.materials.size());
        for (std::size_t i = 0; i < gltf_.meshes.size(); ++i) {
            report(progress_, 0.3 + 0.6 * double(i) / double(gltf_.meshes.size()),
                   "Reading meshes");
            model_.meshes.push_back(make_ref(read_mesh(gltf_.meshes[i])));
        }
        if (default_used_ || model_.materials.empty()) model_.materials.emplace_back();
        read_nodes();
        rig_.add_skins(model_, node_of_);
        rig_.add_clips(model_, node_of_);
        rig_.add_notices(model_);
        say_what_was_left_out();
        return std::move(model_);
    }

private:
    Mesh read_mesh(const tinygltf::Mesh& from)
    {
        struct Vertices {
            std::uint32_t first;
            std::size_t count;
        };
        using Attributes = std::map<std::string, int>;
        std::map<std::pair<Attributes, std::vector<Attributes>>, Vertices> read_before;
        Mesh mesh;
        for (const tinygltf::Primitive& primitive : from.primitives) {
            if (primitive.extensions.contains("KHR_draco_mesh_compression"))
                fail("it is compressed by KHR_draco_mesh_compression, which is not supported");
            const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
            if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
                ++lines_and_points_;
                continue;
            }
            // Primitives that differ in their material only share their vertices.
            const auto [at, added] =
                read_before.emplace(std::pair(primitive.attributes, primitive.targets),
                                    Vertices{static_cast<std::uint32_t>(mesh.vertex_count()), 0});
            if (added) at->second.count = read_attributes(mesh, primitive);
            read_faces(mesh, primitive, mode, at->second.first, at->second.count);
        }
        mesh = without_loose_vertices(std::move(mesh));
        mesh.points = points_by_position(mesh.positions);
        return mesh;
    }

    // Appends the attributes of a primitive. Meshes of several may have an attribute in some only:
    // the others get what changes nothing.
    std::size_t read_attributes(Mesh& mesh, const tinygltf::Primitive& primitive)
    {
        const auto table = [&](const std::string& name, std::size_t least, std::size_t most) {
            const auto at = primitive.attributes.find(name);
            if (at == primitive.attributes.end()) return GltfAccessors::Table{0, 0, {}};
            GltfAccessors::Table read = accessors_.floats(at->second);
            if (read.components < least || read.components > most)
                fail(fmt::format("{} has {} components", name, read.components));
            return read;
        };
        const GltfAccessors::Table positions = table("POSITION", 3, 3);
        const std::size_t before = mesh.vertex_count(), count = positions.count;
        const std::size_t after = before + count;
        if (after > 0xfffffff0u) fail("a mesh has more vertices than can be counted");
        const auto append = [&]<class T>(std::vector<T>& values, const GltfAccessors::Table& read,
                                         T neutral, const char* name) {
            if (read.components == 0 && values.empty()) return;
            if (read.components > 0 && read.count != count)
                fail(fmt::format("{} has {} values for {} positions", name, read.count, count));
            values.resize(before, neutral);
            values.resize(after, neutral);
            for (std::size_t i = 0; read.components > 0 && i < count; ++i)
                for (std::size_t c = 0; c < read.components; ++c)
                    values[before + i][static_cast<int>(c)] = read.values[i * read.components + c];
        };
        append(mesh.positions, positions, glm::vec3(0), "POSITION");
        append(mesh.normals, table("NORMAL", 3, 3), glm::vec3(0), "NORMAL");
        append(mesh.tangents, table("TANGENT", 4, 4), glm::vec4(1, 0, 0, 1), "TANGENT");
        append(mesh.colors, table("COLOR_0", 3, 4), glm::vec4(1), "COLOR_0");
        for (std::size_t set = 0; set < max_uv_sets; ++set) {
            const std::string name = fmt::format("TEXCOORD_{}", set);
            GltfAccessors::Table read = table(name, 2, 2);
            if (read.components == 0 && set >= mesh.uvs.size()) break;
            if (set == mesh.uvs.size()) mesh.uvs.emplace_back();
            for (std::size_t i = 1; i < read.values.size(); i += 2)
                read.values[i] = 1 - read.values[i]; // glTF's v goes down
            append(mesh.uvs[set], read, glm::vec2(0), name.c_str());
        }
        rig_.add_influences(mesh, primitive, count);
        rig_.add_targets(mesh, primitive, count);
        return count;
    }

    void read_faces(Mesh& mesh, const tinygltf::Primitive& primitive, int mode, std::uint32_t first,
                    std::size_t vertices)
    {
        std::vector<std::uint32_t> order;
        if (primitive.indices >= 0) {
            order = accessors_.indices(primitive.indices, vertices);
        } else {
            order.resize(vertices);
            for (std::size_t i = 0; i < vertices; ++i) order[i] = static_cast<std::uint32_t>(i);
        }
        const bool listed = mode == TINYGLTF_MODE_TRIANGLES;
        if (listed && order.size() % 3 != 0) cut_triangles_ = true;
        for (std::size_t i = 0; i + 2 < order.size(); i += listed ? 3 : 1) {
            std::array triangle{order[i], order[i + 1], order[i + 2]};
            if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1)
                std::swap(triangle[1], triangle[2]);
            if (mode == TINYGLTF_MODE_TRIANGLE_FAN) triangle[0] = order[0];
            for (std::uint32_t& v : triangle) v += first;
            add_face(mesh, triangle);
        }
        const bool known = primitive.material >= 0 &&
                           static_cast<std::uint32_t>(primitive.material) < default_material_;
        default_used_ |= !known;
        mesh.face_material.resize(mesh.face_count(),
                                  known ? static_cast<std::uint32_t>(primitive.material)
                                        : default_material_);
    }

    // Depth first from the scene's roots, so that a parent comes before its children.
    void read_nodes()
    {
        struct Visit {
            int node, parent;
        };
        std::vector<Visit> stack;
        const std::vector<int> roots = scene_roots();
        for (std::size_t i = roots.size(); i-- > 0;) stack.push_back({roots[i], -1});
        std::vector<bool> seen(gltf_.nodes.size(), false);
        node_of_.assign(gltf_.nodes.size(), -1);
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            const auto index = static_cast<std::size_t>(visit.node);
            if (visit.node < 0 || index >= gltf_.nodes.size())
                fail(fmt::format("node {} is asked for and not there", visit.node));
            if (seen[index])
                fail(fmt::format("node {} has two parents or is its own ancestor", visit.node));
            seen[index] = true;
            const tinygltf::Node& from = gltf_.nodes[index];
            Node node{from.name, visit.parent, glm::dmat4(1), from.mesh};
            place(node, from, visit.node);
            if (from.mesh >= 0 && static_cast<std::size_t>(from.mesh) >= model_.meshes.size())
                fail(fmt::format("node {} names mesh {}, which is not there", visit.node,
                                 from.mesh));
            if (node.name.empty() && from.mesh >= 0)
                node.name = gltf_.meshes[static_cast<std::size_t>(from.mesh)].name;
            if (from.mesh >= 0) {
                const auto& usual = gltf_.meshes[static_cast<std::size_t>(from.mesh)].weights;
                for (const double weight : from.weights.empty() ? usual : from.weights)
                    node.morph_weights.push_back(std::abs(weight) <= 1e6 ? float(weight) : 0.0f);
            }
            const int self = static_cast<int>(model_.nodes.size());
            node_of_[index] = self;
            model_.nodes.push_back(std::move(node));
            for (std::size_t i = from.children.size(); i-- > 0;)
                stack.push_back({from.children[i], self});
        }
    }

    std::vector<int> scene_roots() const
    {
        if (!gltf_.scenes.empty()) {
            const std::size_t scene =
                gltf_.defaultScene >= 0 &&
                        static_cast<std::size_t>(gltf_.defaultScene) < gltf_.scenes.size()
                    ? static_cast<std::size_t>(gltf_.defaultScene)
                    : 0;
            return gltf_.scenes[scene].nodes;
        }
        std::set<int> roots;
        for (std::size_t i = 0; i < gltf_.nodes.size(); ++i) roots.insert(static_cast<int>(i));
        for (const tinygltf::Node& node : gltf_.nodes)
            for (const int child : node.children) roots.erase(child);
        return {roots.begin(), roots.end()};
    }

    void place(Node& to, const tinygltf::Node& node, int index)
    {
        const auto finite = [&](const std::vector<double>& values) {
            for (const double value : values)
                if (!(std::abs(value) <= 1e18))
                    fail(fmt::format("node {} is placed by a number that is not finite", index));
        };
        finite(node.matrix), finite(node.translation), finite(node.rotation), finite(node.scale);
        glm::dmat4& result = to.to_parent;
        if (node.matrix.size() == 16) {
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r)
                    result[c][r] = node.matrix[static_cast<std::size_t>(4 * c + r)];
            if (result[0][3] != 0 || result[1][3] != 0 || result[2][3] != 0 || result[3][3] != 1)
                fail(fmt::format("node {} has a matrix that is not affine", index));
            to.outer = result;
            return;
        }
        if (node.translation.size() == 3)
            to.rest.translation = {node.translation[0], node.translation[1], node.translation[2]};
        if (node.rotation.size() == 4) {
            const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1],
                               node.rotation[2]);
            if (glm::length(q) > 1e-9)
                to.rest.rotation = glm::normalize(q);
            else
                ++turnless_nodes_;
        }
        if (node.scale.size() == 3) to.rest.scale = {node.scale[0], node.scale[1], node.scale[2]};
        result = to.rest.matrix();
    }

    void say_what_was_left_out()
    {
        const auto say = [&](bool condition, const char* what) {
            if (condition) model_.notices.push_back(fmt::format("{}: {}", file_.name, what));
        };
        say(turnless_nodes_ > 0, "rotations of its nodes that are all zeros turn nothing");
        say(lines_and_points_ > 0, "its lines and points were left out");
        say(cut_triangles_, "a list of triangles was not a multiple of three long");
        say(gltf_.scenes.size() > 1, "only the first of its scenes was read");
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw Rejected(fmt::format("{}: {}", file_.name, what));
    }

    const FileText& file_;
    const tinygltf::Model& gltf_;
    std::shared_ptr<tinygltf::Model> keep_;
    const Progress& progress_;
    GltfAccessors accessors_;
    GltfRig rig_;
    Model model_;
    std::vector<int> node_of_; // the file's nodes in the model, or -1
    std::uint32_t default_material_ = 0;
    std::size_t lines_and_points_ = 0, turnless_nodes_ = 0;
    bool default_used_ = false, cut_triangles_ = false;
};

} // namespace

Model read_gltf(const FileText& file, bool binary, const Progress& progress)
{
    report(progress, 0, "Reading");
    return GltfReader(file, load_gltf(file, binary), progress).read();
}

} // namespace trivar
