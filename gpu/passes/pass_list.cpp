// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/pass_list.h"

#include "gpu/passes/outline.h"
#include "gpu/passes/wire.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::gpu {
namespace {

bool by_all(const Brushes&, const Work&)
{
    return true;
}

bool by_several_samples(const Brushes&, const Work& w)
{
    return w.samples > 1;
}

constexpr std::array of_maps{
    Pass{"cull tiles", [](const Brushes&, const Work& w) { return TileMirror::any(w.picture); },
         [](Brushes& b, const Work& w, const Frame& frame) {
             TileMirror& tiles = b.tools.tiles();
             const bool hides = w.picture.draft && Occluders::worthwhile(w.scene, tiles.counts());
             if (hides) b.occluders.draw(b.tools, frame, w.scene);
             const glm::dmat4 to_clip =
                 glm::translate(glm::dmat4(frame.view_clip), -w.scene.origin_world);
             if (tiles.on_card())
                 tiles.show(hides ? &b.occluders.on_card(b.tools) : nullptr, to_clip,
                            b.tools.programs());
             else
                 tiles.show(hides ? b.occluders.read_back() : DepthPyramid(), to_clip);
         }},
    Pass{"shadow map",
         [](const Brushes& b, const Work& w) {
             return w.picture.settings.shadows && b.shadow_map.stale(w.scene);
         },
         [](Brushes& b, const Work& w, const Frame&) {
             b.shadow_map.draw(b.tools, w.scene, w.quality);
         }},
    Pass{"contact map",
         [](const Brushes& b, const Work& w) {
             const bool lags = w.contact_lags && b.contact_map.drawn();
             return !lags && b.contact_map.stale(w.frame, w.scene, w.contact_px);
         },
         [](Brushes& b, const Work& w, const Frame& frame) {
             b.contact_map.draw(b.tools, frame, w.scene, w.contact_px);
         }},
};

template <int band>
constexpr Pass pass_of_band{"casting",
                            [](const Brushes&, const Work& w) {
                                return !w.scene.volumes.empty() &&
                                       (band == 0 || w.quality.cast_divisor == 1);
                            },
                            [](Brushes& b, const Work& w, const Frame& frame) {
                                b.cast.draw(b.tools, *w.targets, frame, w.scene, w.quality, band);
                            }};
static_assert(CastPass::bands == 16);

constexpr std::array of_sample{
    Pass{"surfaces", by_all,
         [](Brushes& b, const Work& w, const Frame& frame) {
             draw_surfaces(b.tools, *w.targets, frame, w.scene, w.look.clay, w.quality);
         }},
    Pass{"occlusion", by_all,
         [](Brushes& b, const Work& w, const Frame&) {
             draw_occlusion(b.tools, *w.targets, w.quality);
         }},
    Pass{"light", by_all,
         [](Brushes& b, const Work& w, const Frame&) { draw_light(b.tools, *w.targets); }},
    Pass{"backdrop", by_all,
         [](Brushes& b, const Work& w, const Frame&) {
             draw_backdrop(b.tools, *w.targets, w.picture.grid);
         }},
    Pass{"wire", [](const Brushes&, const Work& w) { return w.picture.settings.wire; },
         [](Brushes& b, const Work& w, const Frame& frame) {
             draw_wire(b.tools, *w.targets, frame, w.scene, w.picture.edges);
         }},
    Pass{
        "curves", [](const Brushes& b, const Work&) { return b.curves.any(); },
        [](Brushes& b, const Work& w, const Frame&) { b.curves.draw_within(b.tools, *w.targets); }},
    pass_of_band<0>,
    pass_of_band<1>,
    pass_of_band<2>,
    pass_of_band<3>,
    pass_of_band<4>,
    pass_of_band<5>,
    pass_of_band<6>,
    pass_of_band<7>,
    pass_of_band<8>,
    pass_of_band<9>,
    pass_of_band<10>,
    pass_of_band<11>,
    pass_of_band<12>,
    pass_of_band<13>,
    pass_of_band<14>,
    pass_of_band<15>,
    Pass{"see-through", [](const Brushes& b, const Work& w) { return b.see_through.any(w.scene); },
         [](Brushes& b, const Work& w, const Frame& frame) {
             b.see_through.draw(b.tools, *w.targets, frame, w.scene, w.quality);
         }},
    Pass{
        "average", by_several_samples,
        [](Brushes& b, const Work& w, const Frame&) { add_sample(b.tools, *w.targets, w.sample); }},
};

constexpr std::array over_all{
    Pass{"average", by_several_samples,
         [](Brushes& b, const Work& w, const Frame&) { draw_average(b.tools, *w.targets); }},
    Pass{"encoding", [](const Brushes&, const Work& w) { return w.picture.deep; },
         [](Brushes& b, const Work& w, const Frame&) { encode_color(b.tools, *w.targets); }},
    Pass{"lines", [](const Brushes& b, const Work&) { return b.lines.any(); },
         [](Brushes& b, const Work& w, const Frame&) { b.lines.draw_over(b.tools, *w.targets); }},
    Pass{"outline",
         [](const Brushes& b, const Work& w) {
             return !w.scene.outlined.empty() || b.outlined_curves.any();
         },
         [](Brushes& b, const Work& w, const Frame& frame) {
             draw_outline(b.tools, *w.targets, frame, w.scene, b.outlined_curves, b.curves,
                          w.picture.outline, w.picture.draft);
         }},
};

} // namespace

std::span<const Pass> passes_of_maps()
{
    return of_maps;
}

std::span<const Pass> passes_of_sample()
{
    return of_sample;
}

std::span<const Pass> passes_over_all()
{
    return over_all;
}

} // namespace trivar::gpu
