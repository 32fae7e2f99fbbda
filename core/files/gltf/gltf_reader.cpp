// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/gltf/gltf_clips.h"
#include "core/files/gltf/gltf_instances.h"
#include "core/files/gltf/gltf_materials.h"
#include "core/files/gltf/gltf_mesh.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_skins.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Largest number of line points shown by all nodes together; nodes may share their lines.
constexpr std::size_t most_shown_points = 4 * most_curve_points;

// Reads the meshes that nodes name, in the order of the file, and gives the nodes their new
// numbers.
void add_named_meshes(Model& model, GltfMeshes& meshes, const GltfFile& file,
                      CountedNotices& notices, const Progress& progress)
{
    const std::size_t count = file.root().count("meshes");
    std::vector<int> number(count, -1), curves(count, -1);
    for (const Node& node : model.nodes)
        if (node.mesh >= 0) number[static_cast<std::size_t>(node.mesh)] = 0;
    std::size_t unnamed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        report(progress, 0.1 + 0.8 * double(i) / double(count), "Reading meshes");
        if (number[i] < 0) {
            ++unnamed;
            continue;
        }
        number[i] = static_cast<int>(model.meshes.size());
        GltfMeshes::Shapes read = meshes.read(file.root().item("meshes", "mesh", i));
        model.meshes.push_back(make_ref(std::move(read.mesh)));
        if (read.curves.line_count() == 0) continue;
        curves[i] = static_cast<int>(model.curves.size());
        model.curves.push_back(make_ref(std::move(read.curves)));
    }
    std::size_t shown = 0, without_room = 0;
    for (Node& node : model.nodes) {
        if (node.mesh < 0) continue;
        node.curves = curves[static_cast<std::size_t>(node.mesh)];
        if (node.curves >= 0) {
            const std::size_t points =
                model.curves[static_cast<std::size_t>(node.curves)]->point_count();
            const bool room = points <= most_shown_points - shown;
            shown += room ? points : 0;
            if (!room) node.curves = -1, ++without_room;
        }
        node.mesh = number[static_cast<std::size_t>(node.mesh)];
    }
    notices.add("the lines of one node were left out: those of all nodes have too many points",
                "the lines of {0} nodes were left out: those of all nodes have too many points",
                without_room);
    notices.add("one mesh belongs to no node of the scene and was left out",
                "{0} meshes belong to no node of the scene and were left out", unnamed);
}

// Throws Rejected if there are no meshes; the reason may be among the notices of omitted parts.
void check_for_faces(const Model& model, const GltfFile& file, const std::vector<std::string>& said)
{
    const auto has_faces = [](const Ref<Mesh>& mesh) { return mesh->face_count() > 0; };
    if (std::ranges::any_of(model.meshes, has_faces) || !model.curves.empty()) return;
    std::string why;
    for (const std::string& notice : said)
        why += (why.empty() ? ": " : "; ") + notice.substr(file.name().size() + 2);
    throw Rejected(fmt::format("{}: it has no faces and no lines{}", file.name(), why));
}

} // namespace

Model read_gltf(const FileText& text, bool binary, const Progress& progress)
{
    report(progress, 0, "Reading");
    CountedNotices notices;
    GltfFile file(text, binary, notices);
    GltfAccessors accessors(file);
    Model model;
    GltfNodes nodes = gltf_nodes(file, notices);
    const std::size_t instances = add_gltf_instances(nodes, accessors, notices);
    model.nodes = std::move(nodes.nodes);
    CountedNotices of_meshes;
    GltfMeshes meshes(accessors, of_meshes);
    add_named_meshes(model, meshes, file, of_meshes, progress);
    check_instances(model, instances, file.name());
    if (meshes.only_points()) throw Rejected(points_alone(file.name()));
    check_for_faces(model, file, of_meshes.sentences(file.name()));
    report(progress, 0.9, "Reading materials"); // last: pictures take longest
    model.materials = gltf_materials(file, notices);
    if (meshes.uses_plain_material() || model.materials.empty()) model.materials.emplace_back();
    add_gltf_skins(model, accessors, nodes.node_of, notices);
    add_gltf_clips(model, accessors, nodes.node_of, notices);
    check_gltf_reach(model, file.name(), notices);
    model.notices = notices.sentences(file.name());
    for (std::string& notice : of_meshes.sentences(file.name()))
        model.notices.push_back(std::move(notice));
    return model;
}

} // namespace trivar
