// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/renderer.h"

#include "core/base/rejected.h"
#include "gpu/pass_clock.h"
#include "gpu/passes/contact_map.h"
#include "gpu/passes/overlays.h"
#include "gpu/passes/sample.h"
#include "gpu/passes/shadow_map.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <optional>

namespace trivar::gpu {
namespace {

// Leaves the context as ImGui and other guests expect it, whatever was drawn.
class StateGuard {
public:
    StateGuard()
    {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
        glGetIntegerv(GL_VIEWPORT, viewport_.data());
        encodes_ = glIsEnabled(GL_FRAMEBUFFER_SRGB);
    }
    ~StateGuard()
    {
        set_state({});
        glDepthMask(GL_TRUE);
        if (!encodes_) glDisable(GL_FRAMEBUFFER_SRGB);
        for (unsigned unit = 0; unit < 16; ++unit) glBindSampler(unit, 0);
        glActiveTexture(GL_TEXTURE0);
        glBindVertexArray(0);
        glUseProgram(0);
        glFrontFace(GL_CCW);
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    }
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    GLint framebuffer_ = 0;
    std::array<GLint, 4> viewport_{};
    bool encodes_ = false;
};

struct StudioKey {
    std::string look;
    double azimuth, elevation;
    bool ground;
    bool operator==(const StudioKey&) const = default;
};

bool any_see_through(const Scene& scene)
{
    for (const SceneItem& item : scene.items)
        for (const MirroredMesh::Part& part : item.mesh->parts)
            if (item.see_through(part)) return true;
    return false;
}

} // namespace

struct Renderer::State {
    Tools tools;
    PassClock clock;
    ShadowMap shadow_map;
    ContactMap contact_map;
    LinePass lines;
    std::optional<Targets> targets;
    StudioKey studio_key;
    std::optional<Studio> studio;

    const Studio& studio_of(const Look& look, const RenderSettings& settings)
    {
        const StudioKey key{settings.look, settings.sun_azimuth, settings.sun_elevation,
                            settings.ground};
        if (!studio || key != studio_key) {
            studio =
                studio_for(look, settings.sun_azimuth, settings.sun_elevation, settings.ground);
            studio_key = key;
        }
        return *studio;
    }

    void draw_sample(const Frame& frame, const Scene& scene, const Look& look,
                     const Quality& quality, bool grid)
    {
        tools.set_frame(frame);
        clock.pass("surfaces", [&] { draw_surfaces(tools, *targets, frame, scene, look.clay); });
        shadow_map.bind();
        clock.pass("occlusion", [&] { draw_occlusion(tools, *targets, quality); });
        contact_map.bind();
        clock.pass("light", [&] { draw_light(tools, *targets); });
        clock.pass("backdrop", [&] { draw_backdrop(tools, *targets, grid); });
        if (any_see_through(scene))
            clock.pass("ghosts", [&] { draw_ghosts(tools, *targets, frame, scene, quality); });
    }
};

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::~Renderer() = default;

unsigned Renderer::draw(const Picture& picture, glm::ivec2 size_px)
{
    constexpr int largest = 16384;
    if (size_px.x < 1 || size_px.y < 1 || size_px.x > largest || size_px.y > largest)
        throw Rejected(fmt::format("A picture of {} x {} pixels cannot be drawn: each side takes "
                                   "1 to {}.",
                                   size_px.x, size_px.y, largest));
    State& s = *state_;
    const StateGuard guard;
    s.clock.start_picture();
    Camera camera = picture.camera;
    camera.size_px = size_px;
    const Look look = look_named(picture.settings.look);
    const Studio& studio = s.studio_of(look, picture.settings);
    Scene scene;
    s.clock.pass("upload", [&] {
        s.tools.mirror().drop_dead();
        scene = scene_of(picture, s.tools.mirror());
    });
    Frame frame = frame_of(picture, camera, scene, look, studio);
    if (!s.targets || s.targets->size_px != size_px) {
        s.targets.reset(); // the old ones first: both at once may be too much
        s.targets.emplace(size_px);
    }

    const int samples = picture.draft ? 1 : std::clamp(picture.samples, 1, 256);
    Quality quality = quality_for(samples, picture.draft);
    if (!picture.settings.ambient_occlusion) quality.occlusion_slices = 0;
    s.shadow_map.fit(frame, scene, picture.draft ? 1024 : 2048);
    s.tools.set_frame(frame);
    if (picture.settings.shadows && s.shadow_map.stale(scene))
        s.clock.pass("shadow map", [&] { s.shadow_map.draw(s.tools, scene); });
    const int contact_px = picture.draft ? 96 : 192;
    if (s.contact_map.stale(frame, scene, contact_px))
        s.clock.pass("contact map", [&] { s.contact_map.draw(s.tools, frame, scene, contact_px); });

    for (int i = 0; i < samples; ++i) {
        s.draw_sample(sample_of(frame, i, samples), scene, look, quality, picture.grid);
        if (samples > 1) s.clock.pass("average", [&] { add_sample(s.tools, *s.targets, i); });
    }
    s.tools.set_frame(frame);
    if (samples > 1) s.clock.pass("average", [&] { draw_average(s.tools, *s.targets); });
    if (!picture.lines.empty())
        s.clock.pass("lines", [&] {
            s.lines.draw(s.tools, *s.targets, frame, picture.lines, scene.origin_world);
        });
    if (std::ranges::any_of(scene.items, &SceneItem::highlighted))
        s.clock.pass("outline",
                     [&] { draw_outline(s.tools, *s.targets, frame, scene, look.accent); });
    return s.targets->color_bytes.name();
}

Image Renderer::render(const Picture& picture, glm::ivec2 size_px)
{
    draw(picture, size_px);
    const StateGuard guard;
    Image image;
    image.size_px = size_px;
    const std::size_t row = static_cast<std::size_t>(size_px.x) * 4;
    image.rgba.resize(row * size_px.y);
    state_->targets->to_bytes.bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    auto top = image.rgba.begin();
    auto bottom = image.rgba.end() - static_cast<std::ptrdiff_t>(row);
    for (; top < bottom; top += row, bottom -= row) std::swap_ranges(top, top + row, bottom);
    return image;
}

int Renderer::pick(glm::ivec2 p_px)
{
    State& s = *state_;
    if (!s.targets) return 0;
    const glm::ivec2 size = s.targets->size_px;
    if (p_px.x < 0 || p_px.y < 0 || p_px.x >= size.x || p_px.y >= size.y) return 0;
    const StateGuard guard;
    std::array<GLuint, 2> id_depth{};
    s.targets->to_ids.bind();
    glReadPixels(p_px.x, size.y - 1 - p_px.y, 1, 1, GL_RG_INTEGER, GL_UNSIGNED_INT,
                 id_depth.data());
    return static_cast<int>(id_depth[0]);
}

const Timings& Renderer::timings() const
{
    return state_->clock.timings();
}

} // namespace trivar::gpu
