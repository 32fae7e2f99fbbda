// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_timer.h"

#include "core/base/mistake.h"

#include <cmath>
#include <limits>

namespace trivar::gpu {
namespace {

double larger(double most, double found)
{
    return std::isnan(found) ? std::numeric_limits<double>::infinity() : std::max(most, found);
}

double between_deg(const glm::dvec3& n, const glm::dvec3& m)
{
    return glm::degrees(std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m)));
}

} // namespace

DeformErrors errors_of(const DeformedArrays& found, const DeformedArrays& exact)
{
    ensure(found.positions.size() == exact.positions.size(), "meshes of two sizes are compared");
    Box box;
    for (const glm::vec3& p : exact.positions) box.add(p);
    DeformErrors out;
    if (!box.empty()) out.diagonal = glm::length(box.size());
    for (std::size_t i = 0; i < exact.positions.size(); ++i)
        out.position = larger(out.position, glm::distance(glm::dvec3(found.positions[i]),
                                                          glm::dvec3(exact.positions[i])));
    if (out.diagonal > 0) out.position /= out.diagonal;
    for (std::size_t i = 0; i < exact.normals.size() && i < found.normals.size(); ++i)
        out.normal_deg = larger(out.normal_deg, between_deg(found.normals[i], exact.normals[i]));
    for (std::size_t i = 0; i < exact.tangents.size() && i < found.tangents.size(); ++i)
        out.tangent_deg = larger(out.tangent_deg, between_deg(glm::vec3(found.tangents[i]),
                                                              glm::vec3(exact.tangents[i])));
    return out;
}

DeformErrors worst(const DeformErrors& a, const DeformErrors& b)
{
    return {std::max(a.position, b.position), std::max(a.normal_deg, b.normal_deg),
            std::max(a.tangent_deg, b.tangent_deg), std::max(a.diagonal, b.diagonal)};
}

DeviceDeformer& DeformTimer::device()
{
    if (!device_) {
        device_ = std::make_unique<DeviceDeformer>();
        device_->programs().take(texts_);
    }
    return *device_;
}

void DeformTimer::take_shaders(const Ref<ShaderTexts>& texts)
{
    texts_ = texts;
    draw_.programs().take(texts);
    if (device_) device_->programs().take(texts);
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

// Returns the mesh with the data that the method reads.
Ref<Mesh> DeformTimer::mesh(const Method& method) const
{
    if (method.normals != NormalsBy::nothing) return mesh_;
    Mesh plain;
    plain.positions = mesh_->positions;
    return make_ref(std::move(plain));
}

double DeformTimer::time_ms(const Stage& stage, Way way, const Method& method, int passes)
{
    if (way == Way::processor) return processor_ms(stage, method);
    if (way == Way::one_phase) return one_phase_ms(stage, method, std::max(passes, 1));
    return two_phases_ms(stage, method, passes);
}

double DeformTimer::processor_ms(const Stage& stage, const Method& method) const
{
    const Deformer deformer(mesh(method), stage.embedding, stage.lattice->displacement.axes);
    DeformedArrays out;
    const auto run = [&] {
        Timings timings;
        out = timed(timings, "deform",
                    [&] { return deformer.arrays(*stage.lattice, std::move(out)); });
        return timings.stages.front().time_ms;
    };
    return least_ms(run, enough_ms_);
}

// The volume for a vertex shader, and what tells the shader of it.
std::vector<std::string> DeformTimer::bound(const Stage& stage, const glm::dvec3& origin_world)
{
    device().bind(stage, from_.bounds, origin_world);
    return volume_defines(device().lattices().lattice(stage.lattice).axes->packed.order,
                          device().reads_texels());
}

double DeformTimer::one_phase_ms(const Stage& stage, const Method& method, int passes)
{
    const std::vector<std::string> volume = bound(stage, glm::dvec3(0));
    draw_.take(from_);
    return least_ms([&] { return timed_ms([&] { draw(volume, method, passes); }); }, enough_ms_);
}

double DeformTimer::two_phases_ms(const Stage& stage, const Method& method, int passes)
{
    device().deform(from_, to_, std::span(&stage, 1), method); // so that the buffers are there
    draw_.take(to_);
    const auto deform = [&] {
        device().deform(from_, to_, std::span(&stage, 1), method);
        draw({}, method, passes);
    };
    return least_ms([&] { return timed_ms(deform); }, enough_ms_);
}

void DeformTimer::draw(const std::vector<std::string>& volume, const Method& method, int passes)
{
    const bool normals = method.normals != NormalsBy::nothing && from_.normals.bytes() > 0;
    for (int pass = 0; pass < passes; ++pass)
        draw_(volume, normals && pass == 0 ? VertexOutputs::normals : VertexOutputs::positions);
}

DeformErrors DeformTimer::errors(const Stage& stage, Way way, const Method& method)
{
    if (way == Way::processor) return {};
    const glm::dvec3 origin = deformed_bounds(stage, from_.bounds).center();
    Embedding near = stage.embedding;
    near.to_rest[3] -= glm::dvec4(origin, 0);
    const Deformer exact(mesh(method), near, stage.lattice->displacement.axes);
    if (way == Way::two_phases) {
        device().deform(from_, to_, std::span(&stage, 1), method, origin);
        return errors_of(read_back(to_), exact.arrays(*stage.lattice));
    }
    const std::vector<std::string> volume = bound(stage, origin);
    draw_.take(from_);
    return errors_of(draw_.captured(volume), exact.arrays(*stage.lattice));
}

} // namespace trivar::gpu
