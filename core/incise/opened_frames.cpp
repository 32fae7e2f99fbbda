// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/opened_frames.h"

namespace trivar {

OpenedFrames::OpenedFrames(Ref<IncisedMesh> incised, Ref<IncisedFlaps> flaps)
    : incised_(std::move(incised)),
      flaps_(std::move(flaps)),
      shut_(bounding_box(*incised_->original))
{
    const Mesh& rest = *incised_->rest;
    std::vector<char> moves(rest.vertex_count(), 0);
    for (const std::uint32_t v : incised_->moved) moves[v] = 1;
    for (std::size_t v = 0; v < moves.size(); ++v)
        if (!moves[v]) still_.add(glm::dvec3(rest.positions[v]));
}

OpenedFrames::Frame OpenedFrames::operator()(std::span<const IncisionOpening> openings,
                                             std::span<const double> lifts) const
{
    if (!is_open(*incised_, openings)) return {incised_->original, shut_};
    const OpenedVertices vertices = opened_vertices(*incised_, openings, {flaps_.get(), lifts});
    std::optional<Mesh> mesh = meshes_->take_back();
    if (!mesh) mesh = *incised_->rest;
    put(*incised_, vertices, *mesh, flaps_.get());
    Frame out{meshes_->lend(*std::move(mesh)), still_};
    for (const glm::vec3& p : vertices.positions) out.box.add(glm::dvec3(p));
    return out;
}

} // namespace trivar
