// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/wire.h"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

// About how long an edge of the item is in the picture.
float edge_px(const SceneItem& item, const Frame& frame)
{
    const glm::vec4 middle = frame.view * glm::vec4((item.lo + item.hi) * 0.5f, 1);
    const float distance = frame.eye.w > 0.5f ? std::max(-middle.z, 1e-6f) : 1;
    const float px_a_unit = frame.clip[1][1] * 0.5f * frame.size_px.y / distance;
    const float edges = static_cast<float>(item.edges->indices->count) / 2;
    return item.extent * px_a_unit / std::sqrt(std::max(edges, 1.0f));
}

} // namespace

ProgramName wire_program(std::vector<std::string> defines)
{
    return {
        .vertex = "wire", .fragment = "wire", .defines = std::move(defines), .geometry = "wire"};
}

void draw_wire(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
               const EdgeStyle& style)
{
    targets.to_color.bind();
    set_state({.depth = DepthTest::less_equal, .blend = true});
    for (const SceneItem& item : scene.items) {
        if (!item.seen || item.drawn_count() == 0) continue;
        if (!item.edges || item.edges->indices->count == 0) continue;
        std::vector<std::string> placing;
        add_placing(placing, item);
        const Program& program = tools.use(wire_program(std::move(placing)));
        program.set("scene_to_clip", frame.view_clip);
        program.set("half_size_px", glm::vec2(frame.size_px) * 0.5f);
        program.set("formed", style.alone ? 1.0f : 0.0f);
        program.set("to_scene", item.to_scene);
        program.set("normal_to_scene", item.normal_to_scene);
        // Edges alone lie over one another, and need no more to be seen.
        const float room = glm::smoothstep(1.5f, 6.0f, edge_px(item, frame));
        const float most = style.alone ? glm::mix(0.07f, 0.4f, room) : glm::mix(0.12f, 0.7f, room);
        program.set("strength", glm::vec2(most, 0.1f));
        program.set("color", glm::vec4(style.color, style.alone ? 1 : item.opacity));
        if (item.copies) item.copies->feed(item.edges->vertices, item.first_copy, false);
        item.edges->vertices.bind();
        const int count = item.edges->indices->count;
        if (item.copies)
            item.copies->draw(GL_LINES, count, 0, item.drawn_count(), item.mesh->parts().size());
        else
            glDrawElements(GL_LINES, count, GL_UNSIGNED_INT, nullptr);
    }
}

} // namespace trivar::gpu
