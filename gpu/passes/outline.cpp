// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/outline.h"

#include "gpu/passes/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

// Returns the part of the picture that holds the outlined items and their outline.
LayerBounds bounds_of(const Frame& frame, const Scene& scene, bool with_curves, int margin_px)
{
    const glm::ivec2 whole(frame.size_px);
    if (with_curves) return {glm::ivec2(0), whole, {}};
    std::vector<glm::vec3> corners;
    for (const SceneItem& item : scene.outlined)
        for (const glm::dvec3& corner : Box{item.lo, item.hi}.corners())
            corners.emplace_back(corner);
    const LayerBounds own = bounds_of_layers(frame, corners);
    const glm::ivec2 lo = glm::max(own.lo_px - margin_px, glm::ivec2(0));
    const glm::ivec2 hi = glm::min(own.lo_px + own.size_px + margin_px, whole);
    return {lo, glm::max(hi - lo, glm::ivec2(0)), {}};
}

} // namespace

void draw_outline(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                  const LinePass& curves, const LinePass& all_curves, const Outline& outline,
                  bool draft)
{
    const float reach_px = outline.width_px + outline.halo_px;
    const LayerBounds part =
        bounds_of(frame, scene, curves.any(), static_cast<int>(std::ceil(reach_px)) + 1);
    const auto only_part = [&] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(part.lo_px.x, part.lo_px.y, part.size_px.x, part.size_px.y);
    };
    targets.to_mask.bind();
    set_state({});
    const std::array<float, 4> none{0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, none.data());
    for (const bool visible : {false, true}) {
        set_state({.depth = visible ? DepthTest::less_equal : DepthTest::off});
        only_part();
        glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE); // the second channel is of lines
        glEnable(GL_POLYGON_OFFSET_FILL);                   // or the instance would hide itself
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
        if (curves.any()) curves.draw_mask(tools, visible ? 1.0f : 0.5f);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    if (all_curves.any()) all_curves.draw_cover(tools, targets);
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
    // Tiles are outlined as one, and so are their gaps.
    const bool tiles = std::ranges::any_of(
        scene.outlined, [](const SceneItem& item) { return item.copies && item.copies->patches; });
    program.set("closed_px", tiles ? 4 * reach_px : 0);
    // About a tap every pixel and a half of the outer ring.
    program.set("taps", draft ? 8 : std::clamp(static_cast<int>(4 * reach_px), 12, 48));
    targets.mask.bind(0);
    tools.full_screen();
}

} // namespace trivar::gpu
