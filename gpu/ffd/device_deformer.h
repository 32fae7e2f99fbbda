// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "gpu/ffd/lattice_mirror.h"
#include "gpu/ffd/stage.h"
#include "gpu/program.h"
#include "gpu/texture.h"

namespace trivar::gpu {

// The ways to evaluate a deformation. All but the first exist to be compared with it.
enum class Sum { nested, raised, filtered }; // filtered: by the device's filter, a preview
enum class NormalsBy { nothing, cofactors, differences };
struct Method {
    Sum sum = Sum::nested;
    NormalsBy normals = NormalsBy::cofactors;
    bool operator==(const Method&) const = default;
};
Method method_of(DeformBy by);

// DeviceVertices are vertices on the device: three floats per position and normal, four per
// tangent, usable as attributes and as storage. An array that a mesh does not have is an empty
// buffer.
struct DeviceVertices {
    Buffer positions, normals, tangents;
    std::size_t count = 0;
    Box bounds; // of the positions; may be larger than needed
};

// A VertexSource is the same in buffers of another owner; null or empty: none.
struct VertexSource {
    VertexSource() = default;
    VertexSource(const DeviceVertices& vertices);
    const Buffer *positions = nullptr, *normals = nullptr, *tangents = nullptr;
    std::size_t count = 0;
    Box bounds;
};
DeviceVertices uploaded_vertices(const Mesh& mesh);
DeformedArrays read_back(const DeviceVertices& vertices);

// DeviceLimits hold the limits of a device that deforming depends on.
struct DeviceLimits {
    int gl_version = 0;             // 43 is 4.3
    std::size_t storage_block = 0;  // bytes that a shader can access at once
    std::size_t groups = 0;         // per dispatch
    std::size_t texels = 0;         // of a texel buffer
    std::size_t slice_vertices = 0; // greatest number that one dispatch deforms
    // in place of storage: it is faster, or the only access of a vertex shader
    bool reads_texels = false;
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

// The defines that make mesh.vert deform as it draws.
std::vector<std::string> volume_defines(const std::array<int, 3>& orders, bool texels);

// Runs the current compute program over `from`, in slices that the device accepts, with the buffers
// bound as vertex_buffers.glsl has them; `to` must have room. Sets the uniform vertex_count, and
// first_vertex where the program has it.
struct Attributes {
    bool normals = false, tangents = false; // beside positions
};
void dispatch_vertices(const Program& program, const VertexSource& from, const DeviceVertices& to,
                       const Attributes& attributes, const DeviceLimits& limits);

// A DeviceDeformer deforms on the device. Two phases: vertices are deformed into buffers, which any
// number of passes draw. One phase: a vertex shader deforms as it draws.
//
// Positions, normals and tangents equal those of trivar::Deformer up to single precision, except
// that a normal which cannot be determined keeps its old value.
class DeviceDeformer {
public:
    // Throws Rejected where the device lacks something that it needs.
    explicit DeviceDeformer(const DeviceLimits& limits = device_limits());

    // Deforms through one volume after another, without read-back. `to` is relative to
    // `origin_world`. Throws Rejected before anything is drawn: orders above 4, order raising of a
    // torn lattice, no room.
    void deform(const VertexSource& from, DeviceVertices& to, std::span<const Stage> stages,
                const Method& method = {}, const glm::dvec3& origin_world = glm::dvec3(0));

    // Binds the volume of one phase for a program with volume_defines(). Throws Rejected.
    void bind(const Stage& stage, const Box& object, const glm::dvec3& origin_world);

    // The box of vertices, or of their image by `by`, relative to `origin_world`. Waits for the
    // device; only 24 bytes are read back.
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

// A box that holds the deformed box: the displacement is a mean of those of the lattice.
Box deformed_bounds(const Stage& stage, const Box& object);

} // namespace trivar::gpu
