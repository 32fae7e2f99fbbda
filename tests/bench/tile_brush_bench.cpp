// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/tiles/tiles.h"
#include "core/evaluation/evaluate.h"
#include "editor/picture/picture.h"
#include "gpu/renderer.h"
#include "tests/editor/rig.h"
#include "tests/support/buffer_traffic.h"

#include <benchmark/benchmark.h>
#include <ctime>
#include <glm/gtc/constants.hpp>

// Measures a brush of tiles on a torus of 20,000 triangles: while it hovers, its first dab, and
// each further dab, alone and among about 100,000 tiles.
namespace trivar {
namespace {

constexpr Id brush_torus = 1, brush_stud = 2;
constexpr double brush_tile_size = 0.0094;

AddTorus add_torus()
{
    return {.shape = {1, 0.4, {144, 72}}};
}
AddSphere add_stud()
{
    return {.shape = {0.5, 16, 8}};
}

Document torus_and_stud()
{
    return after(after(Document{}, add_torus()), add_stud());
}

// A point of the outermost circle, at rest.
TileSample sample_at(double angle, double time_s)
{
    const glm::dvec3 out(std::cos(angle), std::sin(angle), 0);
    return {{1.4 * out, out}, time_s};
}

// The whole torus filled, but for a band along its outermost circle.
Document filled_torus()
{
    TileStroke fill;
    fill.brush = TileBrush::fill;
    fill.size = brush_tile_size;
    fill.samples = {{{{0, 0, 0.4}, {0, 0, 1}}}};
    fill.samples.front().at.p = {1, 0, 0.4};
    TileStroke erase;
    erase.brush = TileBrush::erase;
    erase.size = brush_tile_size;
    erase.radius = 0.05;
    for (int i = 0; i < 400; ++i)
        erase.samples.push_back(sample_at(glm::two_pi<double>() * i / 400, 0.01 * i));
    const Document filled = after(torus_and_stud(), PaintTiles{brush_stud, brush_torus, fill});
    return after(filled, PaintTiles{brush_stud, brush_torus, erase});
}

// A brush whose dabs try 43 places each, on new ground.
TileStroke brush_over(int dabs)
{
    TileStroke stroke;
    stroke.size = brush_tile_size;
    stroke.radius = 2.3 * brush_tile_size;
    stroke.seed = 7;
    for (int i = 0; i < dabs; ++i)
        stroke.samples.push_back(sample_at(2 * stroke.radius / 1.4 * i, 0.01 * i));
    return stroke;
}

std::size_t shown_tiles(const Evaluation& evaluated)
{
    std::size_t count = 0;
    for (const Part& part : evaluated.objects.at(brush_stud)->parts)
        if (part.tiles) count += part.tiles->tiles->size();
    return count;
}

Camera camera_at_brush()
{
    Camera camera;
    camera.eye = {3.2, 0, 2};
    return camera;
}

Evaluator new_brush_evaluator()
{
    return Evaluator(std::make_shared<const AssetStore>(""));
}

// Measures dab after dab of one stroke, from the document's new value to the set of tiles that is
// drawn. The counters hold the tiles, those that a dab lays, and the bytes that a picture sends to
// the card because of it.
void tiles_dab(benchmark::State& state, Document (*make)())
{
    const Document before = make();
    Evaluator evaluate = new_brush_evaluator();
    const gpu::HeadlessContext context;
    gpu::Renderer renderer;
    ShownValues values;
    int dabs = 1;
    const auto with_dabs = [&] {
        return after(before, PaintTiles{brush_stud, brush_torus, brush_over(dabs)});
    };
    std::size_t tiles = shown_tiles(evaluate(with_dabs()));
    const std::size_t first = tiles;
    for (auto _ : state) {
        ++dabs;
        const Document now = with_dabs();
        benchmark::DoNotOptimize(tiles = shown_tiles(evaluate(now)));
    }
    state.counters["tiles"] = static_cast<double>(tiles);
    state.counters["of_a_dab"] = static_cast<double>(tiles - first) / (dabs - 1);

    const auto draw = [&] {
        const Document now = with_dabs();
        gpu::Picture picture = picture_of(evaluate(now), now, camera_at_brush(), values);
        picture.draft = true;
        renderer.draw(picture, {320, 200});
    };
    draw(), draw();
    testing::BufferTraffic traffic;
    draw();
    const std::size_t rest = traffic.bytes_written(); // what every picture sends
    traffic.forget();
    ++dabs;
    draw();
    state.counters["bytes"] = static_cast<double>(traffic.bytes_written());
    state.counters["bytes_of_any_picture"] = static_cast<double>(rest);
}

enum class Dabbed { evaluated, drawn, drawn_again };

// Measures from the document with the first dab of a layer to its picture, with the base shown
// already; or that picture once more.
void tiles_first_dab(benchmark::State& state, Dabbed dabbed)
{
    const gpu::HeadlessContext context;
    const Document before = torus_and_stud(),
                   now = after(before, PaintTiles{brush_stud, brush_torus, brush_over(1)});
    for (auto _ : state) {
        state.PauseTiming();
        {
            Evaluator evaluate = new_brush_evaluator();
            gpu::Renderer renderer;
            ShownValues values;
            const auto draw = [&](const Document& document) {
                gpu::Picture picture =
                    picture_of(evaluate(document), document, camera_at_brush(), values);
                picture.draft = true;
                if (dabbed != Dabbed::evaluated) renderer.draw(picture, {1280, 720});
            };
            draw(before), draw(before);
            if (dabbed == Dabbed::drawn_again) draw(now), draw(now);
            state.ResumeTiming();
            draw(now);
            state.PauseTiming();
        }
        state.ResumeTiming();
    }
}

// Measures the tool and its ring in a frame in which the mouse has moved over the base of a layer,
// in time of this thread.
void tiles_hover(benchmark::State& state)
{
    const auto now_s = [] {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    };
    testing::Rig rig({1280, 720});
    for (const Command& each : {Command(add_torus()), Command(add_stud()),
                                Command(PaintTiles{brush_stud, brush_torus, brush_over(1)})})
        if (!rig.editor.session.run(each)) return state.SkipWithError("a step was refused");
    rig.editor.session.selected = brush_stud;
    rig.editor.session.view.camera = camera_at_brush();
    rig.key({'T'});
    rig.wait();
    ViewportInput input;
    input.rect = rig.layout().view;
    input.hovered = true;
    int step = 0;
    for (auto _ : state) {
        input.mouse = input.rect.size() / 2.0f + glm::vec2(step % 200, (step * 7) % 50);
        ++step;
        double seconds = 0;
        rig.screen.frames(1, [&](ui::Frame&) {
            Tool& tool = rig.editor.active_tool();
            const double begun = now_s();
            tool.use(rig.editor.session, input);
            tool.overlay(rig.editor.session, rig.screen.theme(), input);
            seconds = now_s() - begun;
        });
        state.SetIterationTime(seconds);
    }
}

BENCHMARK_CAPTURE(tiles_dab, alone, torus_and_stud)
    ->MeasureProcessCPUTime()
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_dab, among_100000, filled_torus)
    ->MeasureProcessCPUTime()
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_first_dab, evaluated, Dabbed::evaluated)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_first_dab, drawn, Dabbed::drawn)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_first_dab, drawn_again, Dabbed::drawn_again)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_hover)->UseManualTime()->Iterations(200)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
