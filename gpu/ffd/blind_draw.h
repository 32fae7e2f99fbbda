// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/device_deformer.h"
#include "gpu/framebuffer.h"
#include "gpu/vertex_array.h"

namespace trivar::gpu {

// What a pass wants of mesh.vert. A shadow and picking want positions alone.
enum class Wanted { positions, normals, tangents };

// mesh.vert alone; what it hands on is written where buffers are bound for it.
ProgramName vertex_program(std::vector<std::string> volume_defines, Wanted wanted);

// Runs mesh.vert, the shader of every pass over meshes, over vertices and draws nothing: to time
// it, and to see what it hands on.
class BlindDraw {
public:
    // The vertices to draw from now on: they must live as long.
    void take(const DeviceVertices& vertices);
    // As they are, or in one phase with the volume_defines() of what DeviceDeformer::bind() bound.
    void operator()(const std::vector<std::string>& volume_defines, Wanted wanted);
    // The same, and what came out: positions less the origin of bind().
    DeformedArrays captured(const std::vector<std::string>& volume_defines);
    Programs& programs() { return programs_; }

private:
    void start(const std::vector<std::string>& volume_defines, Wanted wanted);
    void draw() const;
    const DeviceVertices* vertices_ = nullptr;
    VertexArray attributes_;
    Programs programs_;
    Framebuffer nowhere_{{}, nullptr};
};

} // namespace trivar::gpu
