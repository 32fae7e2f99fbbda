// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/renderer.h"

#include "core/base/rejected.h"
#include "gpu/context.h"
#include "gpu/pass_clock.h"
#include "gpu/passes/pass_list.h"
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
        throw Rejected(
            fmt::format("A picture of {} x {} pixels cannot be drawn: each side must have 1 to {}.",
                        size_px.x, size_px.y, largest));
}

} // namespace

struct Renderer::State {
    PassClock clock;
    Brushes brushes;
    std::optional<Targets> drafts, pictures; // apart, for they may differ in size
    const Targets* whole = nullptr;          // those of the last whole picture
    glm::ivec2 whole_px{0};                  // its size before scaling
    bool kept = false;                       // its copy is what shows
    const bool software = is_software();
    bool casts_on_card = !software;
    bool may_lag = false; // what is drawn now
    StudioKey studio_key;
    std::optional<Studio> studio;
    std::optional<Work> work;
    std::string notice; // of the curves

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
        Tools& tools = brushes.tools;
        if (tools.take(picture.shaders)) { // what was drawn before was drawn by others
            brushes.shadow_map = {};
            brushes.contact_map = {};
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
        tools.volumes().drop_dead();
        if (const std::size_t vertices = tools.deformed().stale_vertices(picture); vertices > 0)
            clock.pass(
                "deform on device", [&] { tools.deformed().update(picture, tools.mirror()); },
                vertices);
        else
            tools.deformed().update(picture, tools.mirror());
        const auto choose_tiles = [&] {
            tools.tiles().update(picture, camera, tools.mirror(), tools.programs());
        };
        if (TileMirror::any(picture))
            clock.pass("cull tiles", choose_tiles);
        else
            choose_tiles();
        clock.pass("upload", [&] {
            scene = scene_of(picture, tools.mirror(), tools.deformed(), tools.tiles(),
                             casts_on_card ? &tools.volumes() : nullptr);
            brushes.see_through.load(picture.translucent, scene.origin_world);
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
        work = Work{picture,   std::move(scene), frame,   look, quality,
                    &*targets, shown_px,         samples, 192};
        if (picture.draft) work->contact_px = 96;
        // On software GL what the ground sees of the sky lags behind what is dragged until it
        // rests.
        work->contact_lags = picture.draft && may_lag && software;
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
        brushes.lines.load(helpers.all());
        brushes.curves.load(all.all());
        brushes.outlined_curves.load(outlined.all());
        const std::size_t gone = all.left_out();
        notice = gone == 0 ? ""
                           : fmt::format("The curves have more than {} segments, so {} of them "
                                         "{} not drawn.",
                                         most_segments, gone, gone == 1 ? "is" : "are");
    }

    void draw(const Pass& pass, const Frame& frame)
    {
        if (!pass.needed(brushes, *work)) return;
        clock.pass(pass.name, [&] { pass.draw(brushes, *work, frame); });
    }

    void draw_maps()
    {
        const int shadow_px = work->picture.draft ? 1024 : work->samples < 16 ? 2048 : 4096;
        brushes.shadow_map.fit(work->frame, work->scene, shadow_px);
        brushes.tools.set_frame(work->frame);
        for (const Pass& pass : passes_of_maps()) draw(pass, work->frame);
    }

    // The next pass of a sample that the picture needs.
    void draw_pass()
    {
        const auto& passes = passes_of_sample();
        const auto skip = [&] {
            while (work->next < passes.size() && !passes[work->next].needed(brushes, *work))
                ++work->next;
        };
        skip();
        if (work->next < passes.size()) {
            const Frame frame = sample_of(work->frame, work->sample, work->samples);
            brushes.tools.set_frame(frame);
            brushes.shadow_map.bind();
            brushes.contact_map.bind();
            draw(passes[work->next++], frame);
            skip();
        }
        if (work->next < passes.size()) return;
        work->next = 0;
        ++work->sample;
    }

    void finish()
    {
        brushes.tools.set_frame(work->frame);
        for (const Pass& pass : passes_over_all()) draw(pass, work->frame);
        whole = work->targets;
        whole_px = work->shown_px;
        kept = false;
        work.reset();
    }

    // One step of the work.
    void step()
    {
        if (!std::exchange(work->in_light, true))
            draw_maps();
        else if (work->sample == work->samples)
            finish();
        else
            draw_pass();
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

int Renderer::pick_near(glm::ivec2 p_px, double reach_px)
{
    State& s = *state_;
    const bool inside = s.whole && glm::clamp(p_px, glm::ivec2(0), s.whole_px - 1) == p_px;
    if (!inside) return 0;
    const StateGuard guard;
    const glm::dvec2 scale = glm::dvec2(s.whole->size_px) / glm::dvec2(s.whole_px);
    return id_near(*s.whole, glm::ivec2((glm::dvec2(p_px) + 0.5) * scale), reach_px * scale.x);
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
    Tools& tools = state_->brushes.tools;
    return tools.mirror().bytes() + tools.tiles().bytes() + tools.volumes().bytes();
}

const std::string& Renderer::notice() const
{
    const std::string& of_volumes = state_->brushes.tools.deformed().notice();
    if (!of_volumes.empty()) return of_volumes;
    const std::string& of_data = state_->brushes.tools.volumes().notice();
    return of_data.empty() ? state_->notice : of_data;
}

std::string Renderer::shader_trouble() const
{
    return state_->brushes.tools.shader_trouble();
}

const TileCounts& Renderer::tile_counts() const
{
    return state_->brushes.tools.tiles().counts();
}

void Renderer::choose_tiles_on_card(bool on_card)
{
    state_->brushes.tools.tiles().choose_on_card(on_card);
}

void Renderer::cast_on_card(bool on_card)
{
    state_->casts_on_card = on_card;
}

const Timings& Renderer::timings() const
{
    return state_->clock.timings();
}

} // namespace trivar::gpu
