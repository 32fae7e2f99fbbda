// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/document/asset_store.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"

#include <benchmark/benchmark.h>

// Any frame of a scene, wherever the hand drags: the values of that frame, and what is deformed
// worked out for it, as the window asks for it. A body of 102,397 vertices lies on a stroke over
// hills; its keys change how wide it is, so that its volume is laid anew in every frame, or where
// it is in it, or its colour. The baseline works out the same frames knowing nothing of others.
namespace trivar {
namespace {

Document scene(const std::vector<Track>& tracks)
{
    AddPlane plane;
    plane.shape.size = {6, 6};
    Document document = after({}, plane);
    AddSphere body;
    body.shape = {.radius = 0.3, .segments = 318, .rings = 320};
    document = after(document, body);
    Place place;
    place.object = 2;
    place.sketch.camera.eye = {0.5, -6, 4};
    for (int i = 0; i < 20; ++i)
        place.sketch.samples.push_back({{500 + 15 * i, 360 + 3 * (i % 5)}, 0.02 * i, 1});
    place.parameters.fill = 0.4;
    place.onto = {1};
    for (const double x : {-0.7, 0.1, 0.8}) {
        AddSphere hill;
        hill.shape.radius = 0.4;
        hill.transform.translation = {x, 0, -0.2};
        place.onto.push_back(document.next_id);
        document = after(document, hill);
    }
    document = after(document, place);
    document = after(document, SetMaterial{{2}, Surfacing{}});
    return tracks.empty() ? document : after(document, Animate{{{2, tracks}}});
}

std::vector<Key> up_and_down(double lo, double hi)
{
    return {{1, lo}, {60, hi}, {120, lo}, {180, hi}, {240, lo}};
}

enum class How { as_the_window, knowing_nothing, values_alone };

void scrub(benchmark::State& state, const std::vector<Track>& tracks, How how)
{
    const Document document = scene(tracks);
    const auto assets = std::make_shared<const AssetStore>("");
    Evaluator kept(assets);
    std::size_t vertices = 0;
    int frame = 1;
    const auto show = [&] {
        frame = 1 + (frame + 96) % 239; // far from the one before, and seldom again
        const Document now = document_at(document, frame);
        if (how == How::values_alone) return benchmark::DoNotOptimize(now.objects.size());
        Evaluator fresh(assets);
        const Evaluation evaluated = (how == How::as_the_window ? kept : fresh)(now, frame);
        if (!evaluated.objects.at(2)->placement) state.SkipWithError("it does not lie there");
        vertices = 0;
        for (const Part& part : evaluated.objects.at(2)->parts)
            vertices += part.mesh()->vertex_count();
    };
    show();
    for (auto _ : state) show();
    state.counters["vertices"] = static_cast<double>(vertices);
}
void frames(benchmark::internal::Benchmark* each)
{
    each->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
const std::vector<Track> width{{"placement.width", up_and_down(0.3, 0.5)}},
    start{{"placement.start", up_and_down(0, 0.5)}},
    roughness{{"material.roughness", up_and_down(0, 1)}};
BENCHMARK_CAPTURE(scrub, width, width, How::as_the_window)->Apply(frames);
BENCHMARK_CAPTURE(scrub, width_knowing_nothing, width, How::knowing_nothing)->Apply(frames);
BENCHMARK_CAPTURE(scrub, start, start, How::as_the_window)->Apply(frames);
BENCHMARK_CAPTURE(scrub, start_knowing_nothing, start, How::knowing_nothing)->Apply(frames);
BENCHMARK_CAPTURE(scrub, roughness, roughness, How::as_the_window)->Apply(frames);
BENCHMARK_CAPTURE(scrub, values_alone, width, How::values_alone)->Apply(frames);

} // namespace
} // namespace trivar
