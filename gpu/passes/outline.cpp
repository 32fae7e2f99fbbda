// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

struct Rectangle {
    glm::ivec2 lo, size;
};

// The part of the picture that holds the highlighted instances and their outline.
Rectangle bounds_px(const Frame& frame, const Scene& scene, glm::ivec2 size_px, int margin_px)
{
    glm::vec2 lo(1), hi(-1);
    for (const SceneItem& item : scene.outlined)
        for (int k = 0; k < 8; ++k) {
            const glm::vec3 p((k & 1 ? item.hi : item.lo).x, (k & 2 ? item.hi : item.lo).y,
                              (k & 4 ? item.hi : item.lo).z);
            const glm::vec4 c = frame.view_clip * glm::vec4(p, 1);
            if (c.w <= 0) return {glm::ivec2(0), size_px}; // beside the eye: anywhere
            lo = glm::min(lo, glm::vec2(c) / c.w);
            hi = glm::max(hi, glm::vec2(c) / c.w);
        }
    lo = glm::clamp(lo, -1.0f, 1.0f) * 0.5f + 0.5f;
    hi = glm::clamp(hi, -1.0f, 1.0f) * 0.5f + 0.5f;
    const glm::ivec2 from =
        glm::max(glm::ivec2(lo * glm::vec2(size_px)) - margin_px, glm::ivec2(0));
    const glm::ivec2 to = glm::min(glm::ivec2(hi * glm::vec2(size_px)) + margin_px + 1, size_px);
    return {from, glm::max(to - from, glm::ivec2(0))};
}

} // namespace

void draw_outline(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                  const Outline& outline, bool draft)
{
    const float reach_px = outline.width_px + outline.halo_px;
    const Rectangle part =
        bounds_px(frame, scene, targets.size_px, static_cast<int>(std::ceil(reach_px)) + 2);
    const auto only_part = [&] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(part.lo.x, part.lo.y, part.size.x, part.size.y);
    };
    targets.to_mask.bind();
    set_state({});
    const std::array<float, 4> none{0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, none.data());
    for (const bool visible : {false, true}) {
        set_state({.depth = visible ? DepthTest::less_equal : DepthTest::off});
        only_part();
        glEnable(GL_POLYGON_OFFSET_FILL); // or the instance would hide itself
        glPolygonOffset(-1, -2);
        MeshPass pass;
        pass.fragment = "mask";
        pass.scene_to_clip = frame.view_clip;
        pass.reads_material = false;
        pass.wanted = [](const SceneItem&, const auto&) { return true; };
        pass.prepare = [visible](const Program& program, const SceneItem&) {
            program.set("value", visible ? 1.0f : 0.5f);
        };
        tools.draw(scene.outlined, pass);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    targets.to_encoded.bind();
    set_state({.blend = true});
    only_part();
    std::vector<std::string> defines;
    if (draft) defines.emplace_back("DRAFT");
    const Program& program = tools.use(full_screen_program("outline", defines));
    program.set("color", outline.color);
    program.set("halo", outline.halo);
    program.set("width_px", outline.width_px);
    program.set("halo_px", outline.halo_px);
    // About a tap every pixel and a half of the outer ring.
    program.set("taps", draft ? 8 : std::clamp(static_cast<int>(4 * reach_px), 12, 48));
    targets.mask.bind(0);
    tools.full_screen();
}

} // namespace trivar::gpu
