// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/layers.h"

#include <array>
#include <epoxy/gl.h>
#include <limits>

namespace trivar::gpu {

LayerBounds bounds_of_layers(const Frame& frame, std::span<const glm::vec3> points_scene)
{
    const glm::ivec2 whole(frame.size_px);
    glm::vec2 lo(1), hi(-1);
    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    bool beside = false; // the eye: anywhere in the picture
    for (const glm::vec3& p : points_scene) {
        const glm::vec4 c = frame.view_clip * glm::vec4(p, 1);
        const float distance = -(frame.view * glm::vec4(p, 1)).z;
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
        if (c.w <= 0) beside = true;
        lo = glm::min(lo, glm::vec2(c) / c.w);
        hi = glm::max(hi, glm::vec2(c) / c.w);
    }
    if (frame.eye.w > 0.5f) nearest = std::max(nearest, 0.0f);
    const glm::vec2 range(nearest, std::max(farthest, nearest));
    if (beside) return {glm::ivec2(0), whole, range};
    lo = glm::clamp(lo, -1.0f, 1.0f) * 0.5f + 0.5f;
    hi = glm::clamp(hi, -1.0f, 1.0f) * 0.5f + 0.5f;
    const glm::ivec2 from = glm::max(glm::ivec2(lo * glm::vec2(whole)) - 1, glm::ivec2(0));
    const glm::ivec2 to = glm::min(glm::ivec2(hi * glm::vec2(whole)) + 2, whole);
    return {from, to - from, range};
}

void LayerPass::draw(Tools& tools, const Targets& targets, const LayerBounds& bounds, Kind kind,
                     const DrawAll& draw_all)
{
    if (bounds.empty()) return;
    const glm::ivec2 size = weighed_.size_px();
    if (size.x < targets.size_px.x || size.y < targets.size_px.y) {
        const glm::ivec2 larger = glm::max(size, targets.size_px);
        for (Texture2D* each : {&near_depths_, &far_depths_, &weighed_, &depths_})
            *each = {}; // both at once may be too much
        near_depths_ = Texture2D(GL_RGBA16F, larger);
        far_depths_ = Texture2D(GL_RGBA16F, larger);
        depths_ = Texture2D(GL_R16F, larger);
        weighed_ = Texture2D(GL_RGBA16F, larger); // last, for its size is asked for
        to_depths_ = Framebuffer({&near_depths_, &far_depths_}, nullptr);
        to_weighed_ = Framebuffer({&weighed_}, nullptr);
        to_both_ = Framebuffer({&weighed_, &depths_}, nullptr);
    }
    const auto only_part = [&] {
        glViewport(0, 0, targets.size_px.x, targets.size_px.y);
        glEnable(GL_SCISSOR_TEST);
        glScissor(bounds.lo_px.x, bounds.lo_px.y, bounds.size_px.x, bounds.size_px.y);
    };
    const auto add_up = [&](const Framebuffer& into, int targets_there,
                            const std::vector<std::string>& defines) {
        const std::array<float, 4> nothing{0, 0, 0, 0};
        into.bind();
        set_state({.blend = true});
        only_part();
        for (int i = 0; i < targets_there; ++i) glClearBufferfv(GL_COLOR, i, nothing.data());
        glBlendFunc(GL_ONE, GL_ONE);
        targets.depth.bind(2);
        draw_all(defines);
    };
    std::vector<std::string> over;
    if (kind.at_once) {
        over = {"LAYERS_AT_ONCE"};
        add_up(to_both_, 2, over);
        depths_.bind(6);
    } else {
        add_up(to_depths_, 2, {"LAYER_DEPTHS"});
        near_depths_.bind(6);
        far_depths_.bind(7);
        add_up(to_weighed_, 1, {});
    }
    (kind.helpers ? targets.to_encoded : targets.to_color).bind();
    set_state({.blend = true});
    only_part();
    tools.use(full_screen_program("layers_over", over));
    weighed_.bind(0);
    tools.full_screen();
    set_state({});
}

} // namespace trivar::gpu
