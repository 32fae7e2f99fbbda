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
    const OpenedVertices vertices = opened_vertices(
        *incised_, openings,
        flaps_ ? lifted_moves(*incised_, *flaps_, lifts, openings) : std::vector<glm::dvec3>());
    std::optional<Mesh> mesh = meshes_->take_back();
    if (!mesh) mesh = *incised_->rest;
    put(*incised_, vertices, *mesh);
    if (flaps_) {
        const auto normals = turned_normals(*incised_, *flaps_, lifts, vertices.positions);
        for (std::size_t i = 0; i < normals.size(); ++i)
            mesh->normals[flaps_->skin[i]] = normals[i];
    }
    Frame out{meshes_->lend(*std::move(mesh)), still_};
    for (const glm::vec3& p : vertices.positions) out.box.add(glm::dvec3(p));
    return out;
}

} // namespace trivar
