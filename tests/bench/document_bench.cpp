// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/log.h"
#include "core/scene/scene_file.h"
#include "tests/support/fixtures.h"

#include <benchmark/benchmark.h>
#include <fstream>
#include <nlohmann/json.hpp>

// A scene of 200 objects and 1,000 small edits, the sizes that docs/benchmarks.md speaks of.
namespace trivar {
namespace {

History edited_scene(int objects, int edits)
{
    History history;
    for (int i = 0; i < objects; ++i) history.run(AddBox{});
    for (int i = objects; i < edits; ++i)
        history.run(SetTransform{1 + i % objects, {.translation = {0.1 * i, 1.0 / (1 + i), 0}}});
    return history;
}

void open_log_of_1000_edits(benchmark::State& state)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    std::ofstream(path) << log_text(edited_scene(200, 1000));
    for (auto _ : state) benchmark::DoNotOptimize(SceneFile(path));
}
BENCHMARK(open_log_of_1000_edits)->Unit(benchmark::kMillisecond);

// One object that goes from key to key, in one line of the log.
std::string log_of_keys(std::int64_t count)
{
    Track track{"transform.translation.x", {}};
    for (std::int64_t i = 0; i < count; ++i) {
        const auto frame = static_cast<double>(i);
        track.keys.push_back({.frame = frame, .value = 0.1 * frame});
    }
    return log_header() + command_line(AddBox{}) + command_line(Animate{{{1, {track}}}});
}

void read_keys(benchmark::State& state)
{
    const std::string text = log_of_keys(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(replay(read_log(text, "keys")));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(read_keys)
    ->Arg(12500)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);

void parse_json_of_keys(benchmark::State& state) // the baseline: the values, as they are written
{
    const std::string text = log_of_keys(state.range(0));
    const std::string line = text.substr(text.rfind('\n', text.size() - 2) + 1);
    for (auto _ : state) benchmark::DoNotOptimize(nlohmann::json::parse(line));
}
BENCHMARK(parse_json_of_keys)->Arg(12500)->Arg(100000)->Unit(benchmark::kMillisecond);

void edit_what_has_100000_keys(benchmark::State& state)
{
    History history = replay(read_log(log_of_keys(100000), "keys"));
    double x = 0;
    for (auto _ : state) history.propose(SetTransform{1, {.translation = {x += 0.1, 0, 0}}});
}
BENCHMARK(edit_what_has_100000_keys)->Unit(benchmark::kMicrosecond);

void undo_and_redo_with_200_objects(benchmark::State& state)
{
    History history = edited_scene(200, 1000);
    for (auto _ : state) {
        history.undo();
        history.redo();
    }
}
BENCHMARK(undo_and_redo_with_200_objects);

void undo_by_replaying_with_200_objects(benchmark::State& state) // the baseline: no kept documents
{
    const History history = edited_scene(200, 1000);
    for (auto _ : state) {
        History again;
        for (std::size_t i = 0; i + 1 < history.steps().size(); ++i)
            again.run(history.steps()[i].command);
        benchmark::DoNotOptimize(again);
    }
}
BENCHMARK(undo_by_replaying_with_200_objects)->Unit(benchmark::kMillisecond);

void commit_to_file_with_200_objects(benchmark::State& state)
{
    const testing::TemporaryFolder folder;
    SceneFile scene;
    for (int i = 0; i < 200; ++i) scene.run(AddBox{});
    scene.save_as(folder.file("a.trivar"));
    double x = 0;
    for (auto _ : state) scene.run(SetTransform{1, {.translation = {x += 0.1, 0, 0}}});
}
BENCHMARK(commit_to_file_with_200_objects)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace trivar
