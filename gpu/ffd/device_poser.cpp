// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/device_poser.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace trivar::gpu {
namespace {

constexpr unsigned rig_binding = 0, pose_binding = 1; // pose.comp.glsl

int kinds_of(const Mesh& mesh)
{
    int kinds = mesh.morph_targets.empty() ? 0 : 1;
    for (const Mesh::MorphTarget& target : mesh.morph_targets)
        kinds = std::max({kinds, target.normals.empty() ? 0 : 2, target.tangents.empty() ? 0 : 3});
    return kinds;
}

std::vector<float> rig_values(const Mesh& mesh, int kinds)
{
    std::vector<float> out;
    for (const Mesh::Influences& by : mesh.influences) {
        for (const std::uint16_t joint : by.joints) out.push_back(static_cast<float>(joint));
        for (int k = 0; k < 4; ++k) out.push_back(by.weights[k]);
    }
    for (const Mesh::MorphTarget& target : mesh.morph_targets)
        for (int kind = 0; kind < kinds; ++kind) {
            const std::vector<glm::vec3>& values = kind == 0   ? target.positions
                                                   : kind == 1 ? target.normals
                                                               : target.tangents;
            const std::size_t before = out.size();
            for (const glm::vec3& d : values) out.insert(out.end(), {d.x, d.y, d.z});
            out.resize(before + 3 * mesh.vertex_count(), 0);
        }
    return out;
}

std::vector<float> pose_values(const Pose& pose)
{
    std::vector<float> out;
    for (const glm::mat4& joint : pose.joints)
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) out.push_back(joint[c][r]);
    out.insert(out.end(), pose.morph_weights.begin(), pose.morph_weights.end());
    return out;
}

} // namespace

ProgramName pose_program(bool skinned, int kinds, bool normals, bool tangents)
{
    ProgramName name{"", "", {fmt::format("KINDS {}", kinds)}, "pose"};
    name.defines.emplace_back(normals ? "NORMALS 1" : "NORMALS 0");
    if (skinned) name.defines.emplace_back("SKINNED");
    if (tangents) name.defines.emplace_back("TANGENTS");
    return name;
}

const DevicePoser::Rig& DevicePoser::rig(const Ref<Mesh>& mesh)
{
    Rig& found = rigs_[mesh.get()];
    if (found.alive.lock() == mesh) return found;
    const int kinds = kinds_of(*mesh);
    const std::vector<float> values = rig_values(*mesh, kinds);
    const auto bytes = std::as_bytes(std::span(values));
    if (bytes.size() > limits_.storage_block)
        throw Rejected(fmt::format("The joints and morph targets of a mesh take {} MB; shaders of "
                                   "this graphics card see {}.",
                                   bytes.size() >> 20, limits_.storage_block >> 20));
    found.kinds = kinds;
    found.targets = target_bounds(*mesh);
    found.buffer.write(bytes);
    found.alive = mesh;
    return found;
}

void DevicePoser::pose(const VertexSource& from, DeviceVertices& to, const PosedMesh& posed)
{
    const Rig& by = rig(posed.rest);
    const std::vector<float> values = pose_values(posed.pose);
    pose_.write(std::as_bytes(std::span(values)));
    const auto has = [](const Buffer* buffer) { return buffer && buffer->bytes() > 0; };
    const bool normals = has(from.normals), tangents = normals && has(from.tangents);
    to.positions.reserve(from.positions->bytes());
    if (normals) to.normals.reserve(from.normals->bytes());
    if (tangents) to.tangents.reserve(from.tangents->bytes());
    to.count = from.count;
    to.bounds = posed_bounds(from.bounds, by.targets, posed.pose);
    const Program& program =
        programs_.use(pose_program(!posed.pose.joints.empty(), by.kinds, normals, tangents));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, rig_binding, by.buffer.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, pose_binding, pose_.name());
    program.set("all_vertices", static_cast<int>(from.count));
    program.set("differences_at",
                posed.rest->influences.empty() ? 0 : static_cast<int>(8 * from.count));
    program.set("joint_count", static_cast<int>(posed.pose.joints.size()));
    program.set("target_count", static_cast<int>(posed.pose.morph_weights.size()));
    dispatch_vertices(program, from, to, {normals, tangents}, limits_);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void DevicePoser::drop_dead()
{
    std::erase_if(rigs_, [](const auto& item) { return item.second.alive.expired(); });
}

} // namespace trivar::gpu
