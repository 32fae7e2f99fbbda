// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "gpu/ffd/lattice_mirror.h"
#include "gpu/ffd/stage.h"
#include "gpu/program.h"
#include "gpu/texture.h"

namespace trivar::gpu {

// How a deformation is evaluated. All but the first are there to be compared with it.
enum class Sum { nested, raised, filtered }; // filtered: by the device's filter, a preview
enum class NormalsBy { nothing, cofactors, differences };
struct Method {
    Sum sum = Sum::nested;
    NormalsBy normals = NormalsBy::cofactors;
    bool operator==(const Method&) const = default;
};
Method method_of(DeformBy by);

// Vertices on the device: three floats a position and a normal, four a tangent, as attributes and
// storage alike. What a mesh has none of is an empty buffer.
struct DeviceVertices {
    Buffer positions, normals, tangents;
    std::size_t count = 0;
    Box bounds; // of the positions, or more
};

// The same in buffers that belong to somebody; null or empty: none.
struct VertexSource {
    VertexSource() = default;
    VertexSource(const DeviceVertices& vertices);
    const Buffer *positions = nullptr, *normals = nullptr, *tangents = nullptr;
    std::size_t count = 0;
    Box bounds;
};
DeviceVertices uploaded_vertices(const Mesh& mesh);
DeformedArrays read_back(const DeviceVertices& vertices);

// What deforming asks of a device.
struct DeviceLimits {
    int gl_version = 0;             // 43 is 4.3
    std::size_t storage_block = 0;  // bytes that a shader sees at once
    std::size_t groups = 0;         // a dispatch
    std::size_t texels = 0;         // of a texel buffer
    std::size_t slice_vertices = 0; // the most that one dispatch deforms
    bool reads_texels = false;      // rather than storage: it is faster, or all a vertex shader has
};
DeviceLimits device_limits(); // of the current context

// The compute shader "deform".
struct DeformVariant {
    std::array<int, 3> orders{3, 3, 3};
    Method method;
    bool tangents = false, texels = false;
};
ProgramName deform_program(const DeformVariant& variant);
ProgramName bounds_program(std::vector<std::string> volume_defines);

// What makes mesh.vert deform as it draws.
std::vector<std::string> volume_defines(const std::array<int, 3>& orders, bool texels);

// Runs a compute program in use over `from`, in slices that the device takes, with the buffers
// bound as vertex_buffers.glsl has them; `to` has room. Sets vertex_count, and first_vertex where
// it is asked for.
struct Attributes {
    bool normals = false, tangents = false; // beside positions
};
void dispatch_vertices(const Program& program, const VertexSource& from, const DeviceVertices& to,
                       const Attributes& attributes, const DeviceLimits& limits);

// Deforms on the device. Two phases: vertices are deformed to buffers, which any number of passes
// draw. One phase: a vertex shader deforms as it draws.
//
// Positions, normals and tangents are those of trivar::Deformer up to single precision, except that
// where no normal can be told it stays what it was before.
class DeviceDeformer {
public:
    // Throws Rejected where the device lacks what it takes.
    explicit DeviceDeformer(const DeviceLimits& limits = device_limits());

    // Through one volume after another, without read-back. `to` is relative to `origin_world`.
    // Throws Rejected before anything was drawn: orders above 4, order raising of what is torn, no
    // room.
    void deform(const VertexSource& from, DeviceVertices& to, std::span<const Stage> stages,
                const Method& method = {}, const glm::dvec3& origin_world = glm::dvec3(0));

    // For one phase: binds the volume for a program with volume_defines(). Throws Rejected.
    void bind(const Stage& stage, const Box& object, const glm::dvec3& origin_world);

    // The box of vertices, or of what `by` makes of them, less `origin_world`. Waits for the
    // device: 24 bytes are all that comes back.
    Box box_of(const VertexSource& vertices, const Stage* by = nullptr,
               const glm::dvec3& origin_world = glm::dvec3(0));

    LatticeMirror& lattices() { return lattices_; }
    Programs& programs() { return programs_; }
    bool reads_texels() const { return limits_.reads_texels; }

private:
    void deform_by(const Stage& stage, const VertexSource& from, DeviceVertices& to,
                   const Method& method, const glm::dvec3& origin_world);
    DeviceLimits limits_;
    LatticeMirror lattices_;
    Programs programs_;
    Buffer frame_, bounds_;
    std::unique_ptr<Texels> points_, cells_;
};

// Where a box may come to lie by a deformation: the displacement is a mean of those of the lattice.
Box deformed_bounds(const Stage& stage, const Box& object);

} // namespace trivar::gpu
