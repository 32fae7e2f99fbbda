// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/opened_frames.h"

#include <algorithm>
#include <mutex>

namespace trivar {
namespace {

constexpr std::size_t most_spare = 2; // meshes

} // namespace

struct OpenedFrames::Spare {
    std::mutex mutex;
    std::vector<std::unique_ptr<Mesh>> meshes;

    std::unique_ptr<Mesh> take()
    {
        const std::lock_guard lock(mutex);
        if (meshes.empty()) return nullptr;
        std::unique_ptr<Mesh> mesh = std::move(meshes.back());
        meshes.pop_back();
        return mesh;
    }
    // A mesh that is given again gets another address: who knows a mesh by it is not misled.
    void give_back(std::unique_ptr<Mesh> mesh)
    {
        const std::lock_guard lock(mutex);
        if (meshes.size() < most_spare) meshes.push_back(std::make_unique<Mesh>(std::move(*mesh)));
    }
};

OpenedFrames::OpenedFrames(Ref<IncisedMesh> incised)
    : incised_(std::move(incised)),
      shut_(bounding_box(*incised_->original)),
      spare_(std::make_shared<Spare>())
{
    const Mesh& rest = *incised_->rest;
    std::vector<char> moves(rest.vertex_count(), 0);
    for (const std::uint32_t v : incised_->moved) moves[v] = 1;
    for (std::size_t v = 0; v < moves.size(); ++v)
        if (!moves[v]) still_.add(glm::dvec3(rest.positions[v]));
}

OpenedFrames::Frame OpenedFrames::operator()(std::span<const IncisionOpening> openings) const
{
    if (!is_open(*incised_, openings)) return {incised_->original, shut_};
    const OpenedVertices vertices = opened_vertices(*incised_, openings);
    std::unique_ptr<Mesh> mesh = spare_->take();
    if (!mesh) mesh = std::make_unique<Mesh>(*incised_->rest);
    put(*incised_, vertices, *mesh);
    Frame out{{}, still_};
    for (const glm::vec3& p : vertices.positions) out.box.add(glm::dvec3(p));
    out.mesh = Ref<Mesh>(mesh.release(), [spare = spare_](const Mesh* given) {
        spare->give_back(std::unique_ptr<Mesh>(const_cast<Mesh*>(given)));
    });
    return out;
}

} // namespace trivar
