// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_timer.h"

#include "gpu/vertex_array.h"

#include <cmath>
#include <epoxy/gl.h>

namespace trivar::gpu {

DeformErrors errors_of(const Deformed& found, const Deformed& exact)
{
    Box box;
    for (const glm::vec3& p : exact.positions) box.add(p);
    DeformErrors out;
    for (std::size_t i = 0; i < exact.positions.size(); ++i)
        out.position =
            std::max(out.position, double{glm::distance(found.positions[i], exact.positions[i])});
    const double diagonal = glm::length(box.size());
    if (diagonal > 0) out.position /= diagonal;
    for (std::size_t i = 0; i < exact.normals.size() && i < found.normals.size(); ++i) {
        const glm::dvec3 n(found.normals[i]), m(exact.normals[i]);
        out.normal_deg =
            std::max(out.normal_deg,
                     glm::degrees(std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m))));
    }
    return out;
}

DeviceDeformer& DeformTimer::device()
{
    if (!device_) device_ = std::make_unique<DeviceDeformer>();
    return *device_;
}

void DeformTimer::drop_dead()
{
    if (device_) device_->lattices().drop_dead();
}

void DeformTimer::take(const Ref<Mesh>& mesh)
{
    if (mesh_ == mesh) return;
    mesh_ = mesh;
    from_ = uploaded_vertices(*mesh_);
    to_ = {};
}

// The mesh with what the method reads.
Ref<Mesh> DeformTimer::mesh(const Method& method) const
{
    if (method.normals != NormalsBy::nothing) return mesh_;
    Mesh plain;
    plain.positions = mesh_->positions;
    return make_ref(std::move(plain));
}

double DeformTimer::processor_ms(const Stage& stage, const Method& method) const
{
    const Deformer deformer(mesh(method), stage.embedding, stage.lattice->displacement.axes);
    Deformed out;
    const auto run = [&] {
        Timings timings;
        out = timed(timings, "deform",
                    [&] { return deformer.arrays(*stage.lattice, std::move(out)); });
        return timings.stages.front().time_ms;
    };
    return least_ms(run, enough_ms_);
}

double DeformTimer::one_phase_ms(const Stage& stage, const Method& method)
{
    device().bind(stage, from_.bounds, glm::dvec3(0));
    Method possible = method;
    if (from_.normals.bytes() == 0) possible.normals = NormalsBy::nothing;
    VertexArray vertices;
    vertices.attribute(0, from_.positions, 3, sizeof(glm::vec3));
    if (possible.normals != NormalsBy::nothing)
        vertices.attribute(1, from_.normals, 3, sizeof(glm::vec3));
    vertices.bind();
    nowhere_.bind();
    const std::array<int, 3> order = device().lattices().lattice(stage.lattice).axes->packed.order;
    programs_.use(deform_program({order, possible, false, device().reads_texels(), false}));
    const auto draw = [&] { glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(from_.count)); };
    const double least = least_ms([&] { return timed_ms(draw); }, enough_ms_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return least;
}

double DeformTimer::two_phases_ms(const Stage& stage, const Method& method)
{
    const auto deform = [&] { device().deform(from_, to_, std::span(&stage, 1), method); };
    return least_ms([&] { return timed_ms(deform); }, enough_ms_);
}

DeformErrors DeformTimer::errors(const Stage& stage, const Method& method) const
{
    const Deformer exact(mesh(method), stage.embedding, stage.lattice->displacement.axes);
    return errors_of(read_back(to_), exact.arrays(*stage.lattice));
}

} // namespace trivar::gpu
