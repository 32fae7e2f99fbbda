// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/device_deformer.h"
#include "gpu/framebuffer.h"
#include "gpu/vertex_array.h"

namespace trivar::gpu {

// The outputs of mesh.vert that a pass needs. A shadow and picking need positions only.
enum class VertexOutputs { positions, normals, tangents };

// The program of mesh.vert alone; its outputs are written to the buffers that are bound for them.
ProgramName vertex_program(std::vector<std::string> volume_defines, VertexOutputs outputs);

// A BlindDraw runs mesh.vert, the shader of every pass over meshes, over vertices and draws
// nothing: to measure its time, and to see its outputs.
class BlindDraw {
public:
    // Sets the vertices to draw from now on; they must live as long.
    void take(const DeviceVertices& vertices);
    // Draws them undeformed, or in one phase with the volume_defines() of what
    // DeviceDeformer::bind() bound.
    void operator()(const std::vector<std::string>& volume_defines, VertexOutputs outputs);
    // The same, with the outputs: positions relative to the origin of bind().
    DeformedArrays captured(const std::vector<std::string>& volume_defines);
    Programs& programs() { return programs_; }

private:
    void start(const std::vector<std::string>& volume_defines, VertexOutputs outputs);
    void draw() const;
    const DeviceVertices* vertices_ = nullptr;
    VertexArray attributes_;
    Programs programs_;
    Framebuffer nowhere_{{}, nullptr};
};

} // namespace trivar::gpu
