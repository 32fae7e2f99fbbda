// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/blind_draw.h"

#include <epoxy/gl.h>

namespace trivar::gpu {

ProgramName vertex_program(std::vector<std::string> volume_defines, VertexOutputs outputs)
{
    ProgramName name{"mesh", "", std::move(volume_defines)};
    name.captured = {"at_scene"};
    if (outputs != VertexOutputs::positions) name.captured.emplace_back("at_normal");
    if (outputs == VertexOutputs::tangents) {
        name.captured.emplace_back("at_tangent");
        name.defines.emplace_back("TEXTURES 1");
    }
    return name;
}

void BlindDraw::take(const DeviceVertices& vertices)
{
    vertices_ = &vertices;
    attributes_ = {};
    attributes_.attribute(0, vertices.positions, 3, sizeof(glm::vec3));
    if (vertices.normals.bytes() > 0)
        attributes_.attribute(1, vertices.normals, 3, sizeof(glm::vec3));
    if (vertices.tangents.bytes() > 0)
        attributes_.attribute(2, vertices.tangents, 4, sizeof(glm::vec4));
}

void BlindDraw::operator()(const std::vector<std::string>& volume_defines, VertexOutputs outputs)
{
    start(volume_defines, outputs);
    draw();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

DeformedArrays BlindDraw::captured(const std::vector<std::string>& volume_defines)
{
    const VertexOutputs outputs = vertices_->tangents.bytes() > 0  ? VertexOutputs::tangents
                                  : vertices_->normals.bytes() > 0 ? VertexOutputs::normals
                                                                   : VertexOutputs::positions;
    start(volume_defines, outputs);
    DeviceVertices out;
    unsigned binding = 0;
    for (const auto& [from, to] : {std::pair{&vertices_->positions, &out.positions},
                                   std::pair{&vertices_->normals, &out.normals},
                                   std::pair{&vertices_->tangents, &out.tangents}}) {
        if (from->bytes() == 0) break;
        to->reserve(from->bytes());
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, binding++, to->name());
    }
    glBeginTransformFeedback(GL_POINTS);
    draw();
    glEndTransformFeedback();
    while (binding > 0) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, --binding, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return read_back(out);
}

void BlindDraw::start(const std::vector<std::string>& volume_defines, VertexOutputs outputs)
{
    const Program& program = programs_.use(vertex_program(volume_defines, outputs));
    program.set("to_scene", glm::mat4(1));
    program.set("normal_to_scene", glm::mat3(1));
    glm::mat4 behind_the_eye(0);
    behind_the_eye[3].w = -1; // rather than a discard, which a driver may take for no work at all
    program.set("scene_to_clip", behind_the_eye);
    attributes_.bind();
    nowhere_.bind();
}

void BlindDraw::draw() const
{
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices_->count));
}

} // namespace trivar::gpu
