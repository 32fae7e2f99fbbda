// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/renderer.h"

#include "core/base/rejected.h"
#include "gpu/context.h"
#include "gpu/pass_clock.h"
#include "gpu/passes/contact_map.h"
#include "gpu/passes/layers.h"
#include "gpu/passes/outline.h"
#include "gpu/passes/sample.h"
#include "gpu/passes/shadow_map.h"
#include "gpu/passes/wire.h"
#include "gpu/state_guard.h"

#include <algorithm>
#include <chrono>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace trivar::gpu {
namespace {

struct StudioKey {
    std::string look;
    double azimuth, elevation;
    bool ground;
    bool operator==(const StudioKey&) const = default;
};

void check_size(glm::ivec2 size_px)
{
    const int largest = largest_texture_px();
    if (size_px.x < 1 || size_px.y < 1 || size_px.x > largest || size_px.y > largest)
        throw Rejected(fmt::format("A picture of {} x {} pixels cannot be drawn: each side takes "
                                   "1 to {}.",
                                   size_px.x, size_px.y, largest));
}

} // namespace

// A picture that is being drawn: what from, and how far it is.
struct Work {
    Picture picture;
    Scene scene;
    Frame frame;
    Look look;
    Quality quality;
    Targets* targets;
    glm::ivec2 shown_px; // the size before scaling
    int samples;
    int sample = 0;        // the next one
    std::size_t next = 0;  // of its passes
    bool in_light = false; // the maps are drawn
};

struct Renderer::State {
    Tools tools;
    PassClock clock;
    ShadowMap shadow_map;
    ContactMap contact_map;
    LinePass lines, curves, outlined_curves;
    SeeThroughPass see_through;
    std::optional<Targets> drafts, pictures; // apart, for they may differ in size
    const Targets* whole = nullptr;          // those of the last whole picture
    glm::ivec2 whole_px{0};                  // its size before scaling
    bool kept = false;                       // its copy is what shows
    const bool software = is_software();
    bool may_lag = false; // what is drawn now
    StudioKey studio_key;
    std::optional<Studio> studio;
    std::optional<Work> work;

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

    void begin(const Picture& picture, glm::ivec2 size_px)
    {
        clock.start_picture();
        work.reset();
        if (tools.take(picture.shaders)) { // what was drawn before was drawn by others
            shadow_map = {};
            contact_map = {};
        }
        const glm::ivec2 shown_px = size_px;
        size_px = glm::max(glm::ivec2(glm::dvec2(size_px) * picture.scale + 0.5), 1);
        Camera camera = picture.camera;
        camera.size_px = size_px;
        Look look = look_named(picture.settings.look);
        if (picture.value_colors) look.clay = glm::vec3(0.3f);
        const Studio& light = studio_of(look, picture.settings);
        Scene scene;
        tools.mirror().drop_dead();
        if (const std::size_t vertices = tools.deformed().stale_vertices(picture); vertices > 0)
            clock.pass(
                "deform on device", [&] { tools.deformed().update(picture, tools.mirror()); },
                vertices);
        else
            tools.deformed().update(picture, tools.mirror());
        clock.pass("upload", [&] {
            scene = scene_of(picture, tools.mirror(), tools.deformed());
            see_through.load(picture.translucent, scene.origin_world);
        });
        const Frame frame = frame_of(picture, camera, scene, look, light);
        std::optional<Targets>& targets = picture.draft ? drafts : pictures;
        if (!targets || targets->size_px != size_px || targets->deep != picture.deep) {
            if (targets && whole == &*targets) whole = nullptr;
            targets.reset(); // the old ones first: both at once may be too much
            targets.emplace(size_px, picture.deep);
        }
        const int samples = picture.draft ? 1 : std::clamp(picture.samples, 1, 256);
        Quality quality = quality_for(samples, picture.draft);
        if (!picture.settings.ambient_occlusion) quality.occlusion_slices = 0;
        work = Work{picture, std::move(scene), frame, look, quality, &*targets, shown_px, samples};
        load_lines();
        const auto scale = static_cast<float>(picture.scale);
        work->picture.outline.width_px *= scale;
        work->picture.outline.halo_px *= scale;
    }

    void load_lines()
    {
        const Picture& picture = work->picture;
        const auto none = [&] {
            return Segments(work->frame, work->scene.origin_world, picture.scale);
        };
        Segments helpers = none(), all = none(), outlined = none();
        for (const Line& line : picture.lines) helpers.add(line);
        for (const Curve& curve : picture.curves) {
            all.add(curve);
            if (curve.highlighted) outlined.add(curve);
        }
        lines.load(helpers.all());
        curves.load(all.all());
        outlined_curves.load(outlined.all());
    }

    void draw_maps()
    {
        const bool draft = work->picture.draft;
        shadow_map.fit(work->frame, work->scene, draft ? 1024 : work->samples < 16 ? 2048 : 4096);
        tools.set_frame(work->frame);
        if (work->picture.settings.shadows && shadow_map.stale(work->scene))
            clock.pass("shadow map", [&] { shadow_map.draw(tools, work->scene, work->quality); });
        const int contact_px = draft ? 96 : 192;
        // On software GL what the ground sees of the sky lags behind what is dragged until it
        // rests.
        const bool lags = draft && may_lag && software && contact_map.drawn();
        if (!lags && contact_map.stale(work->frame, work->scene, contact_px))
            clock.pass("contact map",
                       [&] { contact_map.draw(tools, work->frame, work->scene, contact_px); });
    }

    // The next pass of a sample; whether it was the last one.
    bool draw_pass()
    {
        const Work& w = *work;
        const Frame frame = sample_of(w.frame, w.sample, w.samples);
        tools.set_frame(frame);
        if (work->next > 0) shadow_map.bind();
        if (work->next > 1) contact_map.bind();
        switch (work->next++) {
        case 0:
            clock.pass("surfaces", [&] {
                draw_surfaces(tools, *w.targets, frame, w.scene, w.look.clay, w.quality);
            });
            return false;
        case 1:
            clock.pass("occlusion", [&] { draw_occlusion(tools, *w.targets, w.quality); });
            return false;
        case 2: clock.pass("light", [&] { draw_light(tools, *w.targets); }); return false;
        case 3:
            clock.pass("backdrop", [&] { draw_backdrop(tools, *w.targets, w.picture.grid); });
            return false;
        default:
            if (w.picture.settings.wire)
                clock.pass("wire",
                           [&] { draw_wire(tools, *w.targets, frame, w.scene, w.picture.edges); });
            if (curves.any()) clock.pass("curves", [&] { curves.draw_within(tools, *w.targets); });
            if (see_through.any(w.scene))
                clock.pass("see-through",
                           [&] { see_through.draw(tools, *w.targets, frame, w.scene, w.quality); });
            if (w.samples > 1)
                clock.pass("average", [&] { add_sample(tools, *w.targets, w.sample); });
            return true;
        }
    }

    void finish()
    {
        const Work& w = *work;
        tools.set_frame(w.frame);
        if (w.samples > 1) clock.pass("average", [&] { draw_average(tools, *w.targets); });
        if (w.picture.deep) encode_color(tools, *w.targets);
        if (lines.any()) clock.pass("lines", [&] { lines.draw_over(tools, *w.targets); });
        if (!w.scene.outlined.empty() || outlined_curves.any())
            clock.pass("outline", [&] {
                draw_outline(tools, *w.targets, w.frame, w.scene, outlined_curves,
                             w.picture.outline, w.picture.draft);
            });
        whole = w.targets;
        whole_px = w.shown_px;
        kept = false;
        work.reset();
    }

    // One step of the work.
    void step()
    {
        if (!std::exchange(work->in_light, true)) {
            draw_maps();
        } else if (work->sample == work->samples) {
            finish();
        } else if (draw_pass()) {
            ++work->sample;
            work->next = 0;
        }
    }
};

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::~Renderer() = default;

unsigned Renderer::draw(const Picture& picture, glm::ivec2 size_px)
{
    check_size(size_px);
    State& s = *state_;
    const StateGuard guard;
    s.may_lag = true;
    s.begin(picture, size_px);
    while (s.work) s.step();
    return texture();
}

void Renderer::begin(const Picture& picture, glm::ivec2 size_px)
{
    check_size(size_px);
    State& s = *state_;
    const StateGuard guard;
    s.may_lag = false;
    s.begin(picture, size_px);
    if (s.whole != s.work->targets || s.kept) return;
    const Targets& t = *s.whole;
    glCopyImageSubData(t.color_bytes.name(), GL_TEXTURE_2D, 0, 0, 0, 0, t.kept.name(),
                       GL_TEXTURE_2D, 0, 0, 0, 0, t.size_px.x, t.size_px.y, 1);
    s.kept = true;
}

bool Renderer::advance(double budget_ms)
{
    State& s = *state_;
    const StateGuard guard;
    const auto start = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> budget(budget_ms);
    while (s.work) {
        s.step();
        if (std::chrono::steady_clock::now() - start >= budget) break;
    }
    return !s.work;
}

unsigned Renderer::texture() const
{
    const State& s = *state_;
    if (!s.whole) return 0;
    return s.kept ? s.whole->kept.name() : s.whole->color_bytes.name();
}

Image Renderer::render(const Picture& picture, glm::ivec2 size_px)
{
    draw(picture, size_px);
    return image();
}

Image Renderer::image() const
{
    const StateGuard guard;
    return state_->whole ? read_back(*state_->whole) : Image{};
}

DeepImage Renderer::deep_image() const
{
    const StateGuard guard;
    return state_->whole ? read_back_deep(*state_->whole) : DeepImage{};
}

int Renderer::pick(glm::ivec2 p_px)
{
    const std::vector<int> ids = pick_in(p_px, p_px + 1);
    return ids.empty() ? 0 : ids.front();
}

std::vector<int> Renderer::pick_in(glm::ivec2 lo_px, glm::ivec2 hi_px)
{
    State& s = *state_;
    if (!s.whole) return {};
    const glm::ivec2 lo = glm::clamp(lo_px, glm::ivec2(0), s.whole_px);
    const glm::ivec2 hi = glm::clamp(hi_px, lo, s.whole_px);
    if (lo.x == hi.x || lo.y == hi.y) return {};
    const StateGuard guard;
    const glm::ivec2 whole = s.whole->size_px; // a draft may be smaller than it is shown
    const auto drawn_at = [&](glm::ivec2 p_px) {
        return glm::ivec2((glm::dvec2(p_px) + 0.5) * glm::dvec2(whole) / glm::dvec2(s.whole_px));
    };
    const glm::ivec2 first = drawn_at(lo), size = drawn_at(hi - 1) - first + 1;
    return ids_in(*s.whole, first, size);
}

std::size_t Renderer::uploaded_bytes() const
{
    return state_->tools.mirror().bytes();
}

const std::string& Renderer::notice() const
{
    return state_->tools.deformed().notice();
}

std::string Renderer::shader_trouble() const
{
    return state_->tools.shader_trouble();
}

const Timings& Renderer::timings() const
{
    return state_->clock.timings();
}

} // namespace trivar::gpu
