// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

#include <benchmark/benchmark.h>
#include <ctime>
#include <imgui.h>

// Measures a frame of the whole window before its pixels are drawn, with nothing in the scene
// moving: input, keys and all panels.
namespace trivar {
namespace {

void frame_body(benchmark::State& state, SceneFile (*make)(), Editor::Tab tab)
{
    // The clock counts this thread only, not other work of the machine.
    const auto now_s = [] {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    };
    testing::Rig rig({1440, 900});
    rig.editor.session.replace_scene(make());
    rig.wait();
    rig.editor.session.notices.clear();
    rig.editor.session.selected = 1;
    rig.editor.tab = tab;
    rig.screen.settle(rig.body(), 2000);
    for (auto _ : state) {
        double seconds = 0;
        rig.screen.frames(1, [&](ui::Frame& frame) {
            const double begun = now_s();
            draw_editor(rig.editor, frame);
            seconds = now_s() - begun;
        });
        state.SetIterationTime(seconds);
    }
}
void two_hundred(benchmark::internal::Benchmark* each)
{
    each->UseManualTime()->Iterations(200)->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(frame_body, typical, testing::typical_scene, Editor::Tab::inspector)
    ->Apply(two_hundred);
BENCHMARK_CAPTURE(frame_body, objects_1000, testing::scene_of_1000_objects, Editor::Tab::inspector)
    ->Apply(two_hundred);
BENCHMARK_CAPTURE(frame_body, steps_10000, testing::scene_of_10000_steps, Editor::Tab::history)
    ->Apply(two_hundred);
BENCHMARK_CAPTURE(frame_body, log_10000, testing::scene_of_10000_steps, Editor::Tab::log)
    ->Apply(two_hundred);
BENCHMARK_CAPTURE(frame_body, names_of_300, testing::scene_of_long_names, Editor::Tab::inspector)
    ->Apply(two_hundred);

} // namespace
} // namespace trivar
