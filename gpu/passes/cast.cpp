// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/cast.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace trivar::gpu {

ProgramName cast_program(FieldOrder order, bool rough)
{
    std::vector<std::string> defines{fmt::format("FIELD_ORDER {}", static_cast<int>(order) + 2)};
    if (rough) defines.emplace_back("ROUGH");
    return full_screen_program("cast", std::move(defines));
}

ProgramName cast_over_program(bool ids)
{
    return full_screen_program("cast_over",
                               ids ? std::vector<std::string>{"IDS"} : std::vector<std::string>{});
}

namespace {

// The rows of a band that are in the bounds.
LayerBounds within_band(LayerBounds bounds, int height_px, int band)
{
    const int lo = std::max(height_px * band / CastPass::bands, bounds.lo_px.y),
              end = std::min(height_px * (band + 1) / CastPass::bands,
                             bounds.lo_px.y + bounds.size_px.y);
    bounds.lo_px.y = lo;
    bounds.size_px.y = end - lo;
    return bounds;
}

} // namespace

void CastPass::draw(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                    const Quality& quality, int band)
{
    for (const CastItem& item : scene.volumes) {
        LayerBounds bounds = bounds_of_layers(frame, item.corners);
        if (quality.cast_divisor == 1) bounds = within_band(bounds, targets.size_px.y, band);
        if (!bounds.empty()) draw(tools, targets, item, quality, bounds);
    }
}

void CastPass::draw(Tools& tools, const Targets& targets, const CastItem& item,
                    const Quality& quality, const LayerBounds& bounds)
{
    const int by = quality.cast_divisor;
    const glm::ivec2 used = (targets.size_px + by - 1) / by;
    const glm::ivec2 size = gathered_.size_px();
    if (size.x < used.x || size.y < used.y) {
        const glm::ivec2 larger = glm::max(size, used);
        gathered_ = {}; // both at once may be too much
        hits_ = Texture2D(GL_R32F, larger);
        gathered_ = Texture2D(GL_RGBA16F, larger, true);
        to_gathered_ = Framebuffer({&gathered_, &hits_}, nullptr);
    }
    const auto only_there = [](glm::ivec2 lo, glm::ivec2 count) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(lo.x, lo.y, count.x, count.y);
    };
    set_state({});
    to_gathered_.bind();
    glViewport(0, 0, used.x, used.y);
    const glm::ivec2 lo = bounds.lo_px / by;
    const int rim = by > 1 ? 1 : 0; // which interpolation reads
    only_there(lo - rim, (bounds.lo_px + bounds.size_px + by - 1) / by - lo + 2 * rim);
    const std::array<float, 4> nothing{0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_COLOR, 1, nothing.data());
    const MirroredVolume& volume = *item.mirrored;
    const Program& cast = tools.use(cast_program(volume.order, by > 1));
    cast.set("to_voxels", item.to_voxels);
    cast.set("to_normals", item.to_normals);
    cast.set("low", glm::vec4(item.low, 0));
    cast.set("high", glm::vec4(item.high, 0));
    cast.set("last_per_length", glm::vec4(volume.last, item.per_length));
    cast.set("shading_pace", glm::vec2(item.shading, quality.cast_pace));
    cast.set("shares", glm::vec4(volume.sample_share, volume.coefficient_share));
    targets.ids_depths.bind(3);
    volume.samples->texels.bind(0);
    if (volume.coefficients) volume.coefficients->texels.bind(1);
    volume.open.bind(2);
    volume.transfer.bind(6);
    volume.empty.bind(7);
    tools.full_screen();

    gathered_.bind(6);
    hits_.bind(7);
    const glm::vec4 there(glm::vec2(used) / glm::vec2(gathered_.size_px()), 0, 0);
    set_state({.blend = true});
    targets.to_color.bind();
    only_there(bounds.lo_px, bounds.size_px);
    tools.use(cast_over_program(false)).set("there", there);
    tools.full_screen();
    if (item.id == 0) return;
    set_state({.depth = DepthTest::less, .write_depth = true});
    targets.to_ids.bind();
    only_there(bounds.lo_px, bounds.size_px);
    const Program& ids = tools.use(cast_over_program(true));
    ids.set("there", there);
    ids.set("id", static_cast<unsigned>(item.id));
    tools.full_screen();
}

} // namespace trivar::gpu
