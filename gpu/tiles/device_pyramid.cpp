// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/device_pyramid.h"

#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

constexpr int side_of_group = 8; // pyramid.comp.glsl

ProgramName pyramid_program(bool first)
{
    return {"", "", first ? std::vector<std::string>{"FIRST"} : std::vector<std::string>{},
            "pyramid"};
}

} // namespace

std::vector<ProgramName> pyramid_programs()
{
    return {pyramid_program(true), pyramid_program(false)};
}

void DevicePyramid::write(Programs& programs, const Texture2D& depths)
{
    std::vector<glm::ivec2> sizes{depths.size_px()};
    std::size_t count = 0;
    const auto texels = [](glm::ivec2 size) {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    };
    while (sizes.back() != glm::ivec2(1)) sizes.push_back((sizes.back() + 1) / 2);
    for (const glm::ivec2 size : sizes) count += texels(size);
    depths_.reserve(count * sizeof(float));
    size_px_ = depths.size_px();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, depths_.name());
    depths.bind(0);
    glBindSampler(0, 0);
    std::size_t begin = 0, fine_begin = 0;
    for (std::size_t n = 0; n < sizes.size(); ++n) {
        const Program& program = programs.use(pyramid_program(n == 0));
        program.set("width", sizes[n].x);
        program.set("height", sizes[n].y);
        program.set("begin", static_cast<int>(begin));
        if (n > 0) {
            program.set("fine_width", sizes[n - 1].x);
            program.set("fine_height", sizes[n - 1].y);
            program.set("fine_begin", static_cast<int>(fine_begin));
        }
        const glm::uvec2 groups((sizes[n] + side_of_group - 1) / side_of_group);
        glDispatchCompute(groups.x, groups.y, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        fine_begin = begin;
        begin += texels(sizes[n]);
    }
}

} // namespace trivar::gpu
