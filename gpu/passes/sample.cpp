// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/sample.h"

#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace trivar::gpu {

Quality quality_for(int samples, bool draft)
{
    if (draft) return {0, 0, 4, false, true, 2, 1.5f};
    if (samples >= 16) return {1, 6, 6, true, false, 1, 1.0f};
    if (samples >= 4) return {1, 8, 8, true, false, 1, 0.75f};
    return {};
}

std::vector<std::string> Quality::shadow_defines() const
{
    std::vector<std::string> out{fmt::format("SHADOW_BLOCKERS {}", shadow_blockers),
                                 fmt::format("SHADOW_TAPS {}", shadow_taps)};
    if (shadow_blockers == 0) out.emplace_back("SHADOW_RADIUS 3.0"); // texels
    return out;
}

std::vector<std::string> Quality::occlusion_defines() const
{
    std::vector<std::string> out = shadow_defines();
    out.push_back(fmt::format("SLICES {}", occlusion_slices));
    return out;
}

std::vector<std::string> Quality::blur_defines() const
{
    if (occlusion_slices > 0) return {};
    return {"KEY_ALONE"};
}

std::vector<std::string> Quality::ghost_defines(const std::vector<std::string>& of_layers) const
{
    if (of_layers == std::vector<std::string>{"LAYER_DEPTHS"}) return of_layers; // are not lit
    std::vector<std::string> out = shadow_defines();
    out.insert(out.end(), of_layers.begin(), of_layers.end());
    return out;
}

namespace {

// Whether the eye may be within a body.
bool may_be_inside(const Frame& frame, const SceneItem& item)
{
    if (frame.eye.w < 0.5f) return false; // the plane of a parallel view lies before all there is
    const glm::vec3 eye(frame.eye), air = 0.01f * (item.hi - item.lo);
    return glm::all(glm::greaterThan(eye, item.lo - air)) &&
           glm::all(glm::lessThan(eye, item.hi + air));
}

} // namespace

void draw_surfaces(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                   const std::optional<glm::vec3>& clay, const Quality& quality)
{
    targets.to_surfaces.bind();
    set_state({.depth = DepthTest::less, .write_depth = true});
    const std::array<GLuint, 4> nothing{0, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, nothing.data());
    glClearBufferuiv(GL_COLOR, 1, nothing.data());
    glClear(GL_DEPTH_BUFFER_BIT);
    MeshPass pass;
    pass.fragment = "surfaces";
    pass.value_variant = pass.plain_variant = true;
    if (clay) pass.defines.emplace_back("CLAY");
    pass.scene_to_clip = frame.view_clip;
    pass.wanted = opaque;
    pass.prepare = [&](const Program& program, const SceneItem& item) {
        program.set("id", static_cast<unsigned>(item.id));
        if (clay) program.set("clay_color", glm::vec4(*clay, 1));
        if (!item.shows_values()) return;
        program.set("map_colors", scene.map_colors);
        program.set("map_range", scene.map_range);
    };
    const auto backs_are_seen = [&](const SceneItem& item) {
        return quality.backs_of_bodies || !item.is_body() || may_be_inside(frame, item);
    };
    const auto are_tiles = [](const SceneItem& item) {
        return item.copies && item.copies->patches;
    };
    // Front faces first: where they hide the back ones, and that is nearly everywhere, those cost
    // no more than a depth test. Tiles are small, and their vertices cost more than their pixels:
    // they are drawn once.
    pass.without_backs = [&](const SceneItem& item, const MirroredMesh::Part&) {
        return !are_tiles(item) || !backs_are_seen(item);
    };
    tools.draw(scene.items, pass);
    pass.without_backs = {};
    pass.wanted = [&](const SceneItem& item, const MirroredMesh::Part& part) {
        return !are_tiles(item) && backs_are_seen(item) && opaque(item, part);
    };
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    tools.draw(scene.items, pass);
    glDisable(GL_CULL_FACE);
}

void draw_occlusion(Tools& tools, const Targets& targets, const Quality& quality)
{
    set_state({});
    targets.surfaces.bind(2);
    targets.ids_depths.bind(3);
    targets.to_occlusion_noisy.bind();
    tools.use(full_screen_program("occlusion", quality.occlusion_defines()));
    tools.full_screen();
    targets.to_occlusion.bind();
    tools.use(full_screen_program("occlusion_blur", quality.blur_defines()));
    targets.occlusion_noisy.bind(1);
    tools.full_screen();
}

void draw_light(Tools& tools, const Targets& targets)
{
    targets.to_color.bind();
    // The triangle lies at the far plane, so "greater" passes where a surface is: software GL
    // skips the rest in blocks.
    set_state({.depth = DepthTest::greater});
    tools.use(full_screen_program("shade"));
    targets.occlusion.bind(1);
    targets.surfaces.bind(2);
    targets.ids_depths.bind(3);
    tools.full_screen();
}

void draw_backdrop(Tools& tools, const Targets& targets, bool grid)
{
    targets.to_color.bind();
    set_state({.depth = DepthTest::less_equal});
    targets.occlusion.bind(1);
    std::vector<std::string> defines;
    if (grid) defines.emplace_back("GRID");
    if (targets.deep) defines.emplace_back("DEEP");
    tools.use(full_screen_program("backdrop", defines));
    tools.full_screen();
}

namespace {

constexpr int keeps = 0, dithers = 1, encodes = 2, decodes = 3; // average.frag

void copy_color(Tools& tools, const Framebuffer& to, const Texture2D& from, int change)
{
    to.bind();
    set_state({});
    const Program& program = tools.use(full_screen_program("average"));
    program.set("weight", 1.0f);
    program.set("change", change);
    from.bind(0);
    tools.full_screen();
}

} // namespace

void add_sample(Tools& tools, const Targets& targets, int index)
{
    targets.to_sum.bind();
    set_state({.blend = true});
    const Program& program = tools.use(full_screen_program("average"));
    program.set("weight", 1.0f / static_cast<float>(index + 1));
    program.set("change", keeps);
    targets.color.bind(0);
    tools.full_screen();
}

void draw_average(Tools& tools, const Targets& targets)
{
    targets.surfaces.bind(2);
    copy_color(tools, targets.to_color, targets.sum, targets.deep ? keeps : dithers);
}

void encode_color(Tools& tools, const Targets& targets)
{
    copy_color(tools, targets.to_bytes, targets.color, encodes);
}

void decode_color(Tools& tools, const Targets& targets)
{
    copy_color(tools, targets.to_color, targets.color_bytes, decodes);
}

} // namespace trivar::gpu
