// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/model_use.h"

#include "core/base/finite.h"
#include "core/files/companions.h"
#include "core/files/file_bytes.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/pose.h"
#include "tests/fuzz/promises.h"

#include <algorithm>
#include <filesystem>

namespace trivar::testing {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;

void check_mesh(const Mesh& mesh, const std::string& name)
{
    promised("what was read is not sound", [&] { validate(mesh, name); });
    if (!std::ranges::all_of(mesh.positions, finite<glm::vec3>))
        throw Broken("what was read has positions that are not finite");
    if (triangles(mesh).size() != mesh.corners.size() - 2 * mesh.face_count())
        throw Broken("what was read is not cut to as many triangles as it has");
}

void check_stance(const Model& model, const Clip* clip, double time_s)
{
    const Stance stance = stance_at(model, clip, time_s);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].mesh < 0) continue;
        const Pose pose = pose_of(model, static_cast<int>(i), stance);
        const Mesh& rest = *model.meshes[static_cast<std::size_t>(model.nodes[i].mesh)];
        const glm::dmat4 place = mesh_to_model(model, static_cast<int>(i), stance);
        for (const glm::vec3& p : transformed(posed(rest, pose), place).positions)
            if (!finite(p)) throw Broken("where it stands it has positions that are not finite");
    }
}

} // namespace

void check_model(const Model& model, const std::string& name)
{
    check_sentences(model.notices);
    if (model.materials.empty()) throw Broken("what was read has no material");
    for (const Ref<Mesh>& mesh : model.meshes) check_mesh(*mesh, name);
    for (const Ref<Curves>& curves : model.curves) {
        promised("curves that were read are not sound", [&] { validate(*curves, name); });
        for (const std::uint32_t material : curves->material)
            if (material >= model.materials.size()) throw Broken("a line has no material");
    }
    check_stance(model, nullptr, 0);
    for (const Clip& clip : model.clips)
        for (const double time_s : {clip.begin_s, (clip.begin_s + clip.end_s) / 2, clip.end_s})
            check_stance(model, &clip, time_s);
}

void check_written(const Model& model, const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path() / "written";
    std::filesystem::create_directory(folder);
    for (const char* extension : {".glb", ".obj", ".ply", ".stl", ".off"}) {
        const std::string file = (folder / "model").string() + extension;
        if (!allowed([&] { write_model(model, file); })) continue;
        promised("what was written is refused", [&] { check_model(read_model(file), file); });
    }
}

void use_model(const std::string& path)
{
    const std::string name = std::filesystem::path(path).filename().string();
    allowed([&] { check_model(read_model_bytes(read_bytes(path, most_bytes), name, ""), name); });
    allowed([&] { companions_of(path); });
    const Model model = read_model(path);
    check_model(model, name);
    check_written(model, path);
}

} // namespace trivar::testing
