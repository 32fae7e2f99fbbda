// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "editor/jobs/background_evaluator.h"
#include "tests/editor/rig.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

// The whole window plays a sample: while one frame of the scene is drawn, the next one is
// evaluated. The picture fills 1280 x 720 and is drawn with all of its pixels.
namespace trivar {
namespace {

// The time that this share of them stays below.
double quantile(std::vector<double> times, double share)
{
    const auto at = times.begin() + static_cast<std::ptrdiff_t>(share * std::ssize(times));
    std::ranges::nth_element(times, at);
    return *at;
}

void add(std::map<std::string, std::vector<double>>& stages, const Timings& timings)
{
    for (const Timings::Stage& stage : timings.stages)
        stages[stage.name + " ms"].push_back(stage.time_ms);
}

void playing(benchmark::State& state, const std::string& name, const char* pace)
{
    using namespace std::chrono_literals;
    keep_freed_memory(); // as the program does
    testing::Rig rig({1280, 720});
    Session& session = rig.editor.session;
    rig.editor.only_view = true;
    rig.editor.preferences.pace = pace;
    session.replace_scene(SceneFile(TRIVAR_SOURCE_DIR "/assets/scenes/" + name + ".trivar"));
    rig.wait();
    int frame = session.document().time.first_frame;
    std::vector<double> whole;
    std::map<std::string, std::vector<double>> stages;
    const auto next_picture = [&] {
        while (session.evaluator().status().busy) std::this_thread::sleep_for(100us);
        session.poll();
        session.show_frame(++frame);
        rig.frames(1);
        glFinish();
    };
    for (int i = 0; i < 80; ++i) next_picture(); // till the size of drafts has settled
    for (auto _ : state) {
        const double begun_s = now_s();
        next_picture();
        whole.push_back(1e3 * (now_s() - begun_s));
        const ui::TimedPicture& picture = rig.editor.viewport.drafts().pictures().back();
        add(stages, picture.evaluation);
        add(stages, picture.passes);
    }
    state.counters["median ms"] = quantile(whole, 0.5);
    state.counters["best quarter ms"] = quantile(whole, 0.25);
    state.counters["scale"] = rig.editor.viewport.draft_scale();
    for (const auto& [stage, times] : stages) state.counters[stage] = quantile(times, 0.25);
}
void pictures(benchmark::internal::Benchmark* each)
{
    each->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(100);
}
constexpr const char* slow = "0.1"; // pictures a second, so that none is made smaller
BENCHMARK_CAPTURE(playing, whales_whole, "whales", slow)->Apply(pictures);
BENCHMARK_CAPTURE(playing, ants_whole, "ants", slow)->Apply(pictures);
BENCHMARK_CAPTURE(playing, car_whole, "car", slow)->Apply(pictures);
BENCHMARK_CAPTURE(playing, whales_at_pace, "whales", "automatic")->Apply(pictures);
BENCHMARK_CAPTURE(playing, ants_at_pace, "ants", "automatic")->Apply(pictures);
BENCHMARK_CAPTURE(playing, car_at_pace, "car", "automatic")->Apply(pictures);

} // namespace
} // namespace trivar
