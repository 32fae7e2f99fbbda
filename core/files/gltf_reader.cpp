// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/gltf_clips.h"
#include "core/files/gltf_materials.h"
#include "core/files/gltf_mesh.h"
#include "core/files/gltf_nodes.h"
#include "core/files/gltf_skins.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Reads the meshes that nodes name, in the file's order, and gives the nodes their new numbers.
void add_named_meshes(Model& model, GltfMeshes& meshes, const GltfFile& file,
                      CountedNotices& notices, const Progress& progress)
{
    const std::size_t count = file.root().count("meshes");
    std::vector<int> number(count, -1);
    for (const Node& node : model.nodes)
        if (node.mesh >= 0) number[static_cast<std::size_t>(node.mesh)] = 0;
    std::size_t unnamed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        report(progress, 0.3 + 0.6 * double(i) / double(count), "Reading meshes");
        if (number[i] < 0) {
            ++unnamed;
            continue;
        }
        number[i] = static_cast<int>(model.meshes.size());
        model.meshes.push_back(make_ref(meshes.read(file.root().item("meshes", "mesh", i))));
    }
    for (Node& node : model.nodes)
        if (node.mesh >= 0) node.mesh = number[static_cast<std::size_t>(node.mesh)];
    notices.add("one mesh hangs on no node of the scene and was left out",
                "{0} meshes hang on no node of the scene and were left out", unnamed);
}

// What was left out may be why there are none.
void check_for_faces(const Model& model, const GltfFile& file, const CountedNotices& notices)
{
    const auto has_faces = [](const Ref<Mesh>& mesh) { return mesh->face_count() > 0; };
    if (std::ranges::any_of(model.meshes, has_faces)) return;
    std::vector<std::string> left_out = notices.sentences(file.name());
    constexpr std::size_t most_reasons = 3;
    left_out.resize(std::min(left_out.size(), most_reasons));
    std::string why;
    for (const std::string& notice : left_out)
        why += (why.empty() ? ": " : "; ") + notice.substr(file.name().size() + 2);
    throw Rejected(fmt::format("{}: there are no faces in it{}", file.name(), why));
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
    model.nodes = std::move(nodes.nodes);
    report(progress, 0.2, "Reading materials");
    model.materials = gltf_materials(file, notices);
    GltfMeshes meshes(accessors, notices);
    add_named_meshes(model, meshes, file, notices, progress);
    check_for_faces(model, file, notices);
    if (meshes.uses_plain_material() || model.materials.empty()) model.materials.emplace_back();
    add_gltf_skins(model, accessors, nodes.node_of, notices);
    add_gltf_clips(model, accessors, nodes.node_of, notices);
    check_gltf_reach(model, file.name(), notices);
    model.notices = notices.sentences(file.name());
    return model;
}

} // namespace trivar
