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

CastView view_of(const CastItem& item, const Frame& frame, const Quality& quality)
{
    CastView view = item.view;
    const bool perspective = frame.eye.w > 0.5f;
    // The same slopes as in view_point() of frame.glsl.
    const glm::vec2 by_slope(frame.clip[0][0], frame.clip[1][1]);
    const glm::vec2 shift = perspective ? glm::vec2(frame.clip[2]) : -glm::vec2(frame.clip[3]);
    const std::array<glm::vec4, 3> slopes{glm::vec4((shift - 1.0f) / by_slope, 0, 0),
                                          glm::vec4(2 / by_slope.x, 0, 0, 0),
                                          glm::vec4(0, 2 / by_slope.y, 0, 0)};
    const glm::mat4 to_voxels = item.to_voxels * frame.from_view;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec4 foot = perspective ? glm::vec4(0) : slopes[k];
        const glm::vec4 ahead = (perspective ? slopes[k] : glm::vec4(0)) +
                                (k == 0 ? glm::vec4(0, 0, -1, 0) : glm::vec4(0));
        view.rays[k] = to_voxels * (foot + (k == 0 ? glm::vec4(0, 0, 0, 1) : glm::vec4(0)));
        view.rays[3 + k] = to_voxels * ahead;
        view.rays[6 + k] = frame.from_view * ahead;
    }
    view.rays[0].w = perspective ? 1 : 0;
    view.look.z = quality.cast_pace;
    view.look.w = frame.scene.w;
    view.low.w = quality.cast_divisor > 1 ? 0.5f : 1; // what is enlarged shows its dots
    std::ranges::copy(frame.ambient, view.lights.begin());
    view.lights[9] = frame.key_dir;
    view.lights[10] = frame.key_light;
    return view;
}

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

void cast_on_card(Tools& tools, const Targets& targets, const MirroredVolume& volume,
                  const CastView& view, bool rough)
{
    const Program& cast = tools.use(cast_program(volume.order, rough));
    cast.set("rays", view.rays);
    cast.set("lights", view.lights);
    cast.set("low", view.low);
    cast.set("high", view.high);
    cast.set("look", view.look);
    cast.set("to_normals", view.to_normals);
    cast.set("last_place", glm::vec4(volume.last, 0));
    cast.set("shares", glm::vec4(volume.sample_share, volume.coefficient_share));
    volume.samples->texels.bind(0);
    if (volume.coefficients) volume.coefficients->texels.bind(1);
    volume.open.bind(2);
    targets.ids_depths.bind(3);
    volume.transfer.bind(6);
    volume.empty.bind(7);
    tools.full_screen();
}

} // namespace

void CastPass::draw(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                    const Quality& quality, int band)
{
    for (const CastItem& item : scene.volumes) {
        LayerBounds bounds = bounds_of_layers(frame, item.corners);
        if (quality.cast_divisor == 1) bounds = within_band(bounds, targets.size_px.y, band);
        if (!bounds.empty())
            draw(tools, targets, item, view_of(item, frame, quality), quality, bounds);
    }
}

void CastPass::cast_on_processor(const Targets& targets, const CastItem& item, const CastView& view,
                                 glm::ivec2 size_px, const LayerBounds& there, bool linear) const
{
    const glm::dvec2 by = glm::dvec2(targets.size_px) / glm::dvec2(size_px);
    // Returns the pixel of the picture at which a cast pixel looks.
    const auto seen = [&](glm::ivec2 p) {
        return glm::min(glm::ivec2((glm::dvec2(p) + 0.5) * by), targets.size_px - 1);
    };
    const glm::ivec2 lo = seen(there.lo_px), last = seen(there.lo_px + there.size_px - 1),
                     count = last - lo + 1;
    const auto number = [](glm::ivec2 p, int across) {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(across) +
               static_cast<std::size_t>(p.x);
    };
    std::vector<CastSolid> read(number({0, count.y}, count.x)),
        solids(number({0, there.size_px.y}, there.size_px.x));
    targets.to_ids.bind();
    glReadPixels(lo.x, lo.y, count.x, count.y, GL_RG_INTEGER, GL_UNSIGNED_INT, read.data());
    for (int y = 0; y < there.size_px.y; ++y)
        for (int x = 0; x < there.size_px.x; ++x)
            solids[number({x, y}, there.size_px.x)] =
                read[number(seen(there.lo_px + glm::ivec2(x, y)) - lo, count.x)];
    const CastPixels cast =
        cast_image(*item.data, view, size_px, there.lo_px, there.size_px, solids, linear);
    gathered_.write(there.lo_px, there.size_px, cast.gathered);
    hits_.write(there.lo_px, there.size_px, cast.hits);
}

void CastPass::draw(Tools& tools, const Targets& targets, const CastItem& item,
                    const CastView& view, const Quality& quality, const LayerBounds& bounds)
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
    const LayerBounds there{lo, glm::min((bounds.lo_px + bounds.size_px + by - 1) / by, used) - lo};
    const int rim = by > 1 ? 1 : 0; // which interpolation reads
    only_there(lo - rim, there.size_px + 2 * rim);
    const std::array<float, 4> nothing{0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_COLOR, 1, nothing.data());
    if (item.mirrored) {
        only_there(lo, there.size_px);
        cast_on_card(tools, targets, *item.mirrored, view, by > 1);
    } else {
        cast_on_processor(targets, item, view, used, there, by > 1);
    }

    gathered_.bind(6);
    hits_.bind(7);
    const glm::vec4 part(glm::vec2(used) / glm::vec2(gathered_.size_px()), 0, 0);
    set_state({.blend = true});
    targets.to_color.bind();
    only_there(bounds.lo_px, bounds.size_px);
    tools.use(cast_over_program(false)).set("part", part);
    tools.full_screen();
    if (item.id == 0) return;
    set_state({.depth = DepthTest::less, .write_depth = true});
    targets.to_ids.bind();
    only_there(bounds.lo_px, bounds.size_px);
    const Program& ids = tools.use(cast_over_program(true));
    ids.set("part", part);
    ids.set("id", static_cast<unsigned>(item.id));
    tools.full_screen();
}

} // namespace trivar::gpu
