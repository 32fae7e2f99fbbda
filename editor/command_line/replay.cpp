// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/replay.h"
#include "core/stages/walk.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/drawing/drawing_file.h"
#include "core/export/animated_model.h"
#include "core/export/still_export.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/image.h"
#include "core/files/write_model.h"
#include "core/scene_lines/line_sheet.h"
#include "editor/picture/volume_facts.h"
#include "editor/words/volume_words.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <hwy/targets.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace trivar {
namespace {

struct ReplayResult {
    Document document, shown; // shown: refined as --epsilon wants it
    Evaluation evaluated;
    Timings timings;
    bool same = true; // all that --check looked at
    SourceFiles sources;
    HandEdits edits = {}; // in the .svg that the drawing replaces
};

// Results have the same bits on all processors with AVX2, whatever wider units they have.
bool rounds_as_stored()
{
    return (hwy::SupportedTargets() & HWY_AVX2) != 0;
}

// Ctrl C ends it where nothing is half done.
void go_on(const Interrupts& interrupts)
{
    if (interrupts.came()) throw Cancelled();
}

void differs(ReplayResult& replayed, const Streams& streams, const std::string& sentence)
{
    if (replayed.same) streams.talk << "trivar: " << sentence << "\n"; // the first one tells most
    replayed.same = false;
}

void check_line(ReplayResult& replayed, const LogLine& line, const std::string& name,
                const Document& document, Evaluator& evaluator, const Streams& streams)
{
    const std::string causes = line.digest.empty() ? "" : digest(document);
    std::string effects = line.effects;
    if (!line.effects.empty() && rounds_as_stored())
        effects = digest(evaluator(document, line.frame.value_or(document.time.first_frame)));
    else if (!line.effects.empty())
        streams.talk << fmt::format("trivar: {}:{}: the result's digest is not compared: it is "
                                    "that of processors with AVX2, and this one rounds otherwise\n",
                                    name, line.number);
    const auto compare = [&](std::string_view what, const std::string& stored,
                             const std::string& now, std::string_view more) {
        if (stored != now)
            differs(replayed, streams,
                    fmt::format("{}:{}: the {} digest differs: the file says {}, it is {}{}", name,
                                line.number, what, stored, now, more));
    };
    compare("scene's", line.digest, causes,
            line.effects.empty() || line.effects != effects
                ? ""
                : "; the result's is the same, as where only the path of a file is written in "
                  "another way");
    compare("result's", line.effects, effects, "");
}

double frame_of(const ReplayOptions& options, const Document& document)
{
    const Time& time = document.time;
    const int frame = options.frame.value_or(time.first_frame);
    if (frame < time.first_frame || frame > time.last_frame)
        throw Rejected(fmt::format("--frame {}: the scene's frames are {} to {}", frame,
                                   time.first_frame, time.last_frame));
    return frame;
}

// Tells which demands on a volume were not met, or not wholly.
void tell_of_shaping(const ReplayResult& replayed, const Streams& streams)
{
    for (const auto& [id, ref] : replayed.evaluated.objects) {
        if (!ref->shaped) continue;
        const std::string& name = object(replayed.document, id).name;
        const auto tell = [&](std::size_t i, const std::string& words) {
            streams.talk << fmt::format("trivar: {}: step {} of its shaping {}\n", name, i + 1,
                                        words);
        };
        for (std::size_t i = 0; i < ref->shaped->steps.size(); ++i) {
            const Shaping& step = ref->shaped->steps[i];
            if (step.would_fold)
                tell(i, fmt::format("went {} of {} m: its volume would fold", rounded(step.done, 3),
                                    rounded(step.asked, 3)));
            else if (step.asked != 0 && step.done == 0)
                tell(i, "moves nothing");
        }
    }
}

// Tells what is proven of every volume. One that folds may be meant so: this is no check that
// fails.
void tell_of_volumes(const ReplayResult& replayed, const Streams& streams)
{
    for (const auto& [id, ref] : replayed.evaluated.objects) {
        if (!ref->placement) continue;
        streams.talk << fmt::format(
            "trivar: {}: its volume {}; it {}\n", object(replayed.document, id).name,
            words_of(*verdicts_of(*ref)), words_of(overlap(ref->placement->volume)));
    }
}

// Tells how much the planted feet slide that are locked to a travel.
void tell_of_walks(const ReplayResult& replayed, const Streams& streams)
{
    for (const auto& [id, ref] : replayed.evaluated.objects)
        if (ref->walk && ref->walk->trouble.empty())
            streams.talk << fmt::format(
                "trivar: {}: its planted feet slide by {} of a stride at most\n",
                object(replayed.document, id).name, percent_text(*ref->walk->slide));
}

// Says why an object is not shown whole; empty: it is. Tiles that have not grown yet are whole.
std::string why_incomplete(const EvaluatedObject& evaluated)
{
    if (!evaluated.rejected.empty()) return evaluated.rejected;
    if (!evaluated.lacks.empty()) return evaluated.lacks.front();
    const bool shown = !evaluated.shows_nothing() || evaluated.placement;
    return shown || evaluated.notices.empty() ? "" : evaluated.notices.front();
}

// One thread must give the same bits as many, and nothing may be missing.
void check_result(ReplayResult& replayed, const ReplayOptions& options, const Streams& streams)
{
    const ThreadLimit one_thread(1);
    Evaluator again(asset_store(options.scene));
    if (digest(again(replayed.shown, frame_of(options, replayed.document))) !=
        digest(replayed.evaluated))
        differs(replayed, streams,
                fmt::format("{}: one thread gives another result than all of them",
                            options.scene.path));
    for (const auto& [id, ref] : replayed.evaluated.objects)
        if (const std::string why = why_incomplete(*ref); !why.empty())
            differs(replayed, streams,
                    fmt::format("{}: {} is not complete: {}", options.scene.path,
                                object(replayed.document, id).name, why));
}

ReplayResult replay(const ReplayOptions& options, const Streams& streams,
                    const Interrupts& interrupts)
{
    ReplayResult result;
    const Log log = timed(result.timings, "read log", [&] {
        return scene_log(log_text(options.scene), options.scene.path, streams);
    });
    const Ref<AssetStore> assets = asset_store(options.scene);
    Evaluator evaluator(assets, ShutIncisions::vanish, OnFailure::leave_out);
    History history;
    for (const LogLine& line : log.lines) {
        if (options.to > 0 && line.number > options.to) break;
        go_on(interrupts);
        timed(result.timings, "apply", [&] { apply(history, line, log.name); });
        if (options.check)
            check_line(result, line, log.name, history.document(), evaluator, streams);
    }
    result.document = history.document();
    check_relinked(options.scene, result.document);
    if (!options.exports.empty() || !options.image.empty() || !options.timings.empty())
        result.sources = kept_sources(options.scene, result.document, *assets);
    for (const std::string& path : options.exports) result.sources.check(path);
    for (const std::string& path : {options.image, options.timings})
        if (!path.empty()) result.sources.check(path);
    result.shown =
        options.epsilon ? refined_to(result.document, *options.epsilon) : result.document;
    result.evaluated =
        evaluator(result.shown, frame_of(options, result.document), stoppable(streams, interrupts));
    if (still_options(options.drawing).deform == gpu::DeformBy::processor)
        deform_parts(result.evaluated);
    clear_progress(streams);
    result.timings.add(result.evaluated.timings);
    for (const auto& [id, ref] : result.evaluated.objects)
        for (const std::string& notice : ref->notices)
            streams.talk << "trivar: " << object(result.document, id).name << ": " << notice
                         << "\n";
    tell_of_shaping(result, streams);
    if (options.check) {
        tell_of_volumes(result, streams);
        tell_of_walks(result, streams);
        check_result(result, options, streams);
        result.same &= log.notice.empty(); // else its end is lost, as was said
    }
    return result;
}

void draw(const ReplayOptions& options, ReplayResult& replayed, const Streams& streams)
{
    const Document shown = document_at(replayed.shown, frame_of(options, replayed.document));
    check_camera(options.drawing, shown);
    Drawing drawing(options.drawing, streams);
    const Camera camera = drawing.camera(replayed.evaluated, shown);
    if (is_line_sheet(options.image)) {
        const auto [sheet, edited, notices] = timed(replayed.timings, "lines", [&] {
            return line_sheet(replayed.evaluated, shown, camera, replayed.edits);
        });
        if (edited.done + edited.lost + edited.added > 0)
            streams.talk << "trivar: " << options.image << ": " << words_of(edited) << "\n";
        for (const std::string& notice : notices) streams.talk << "trivar: " << notice << "\n";
        if (sheet.layers.empty())
            streams.talk << "trivar: " << options.image << ": no line is seen\n";
        return write_bytes(options.image, drawing_bytes(sheet, drawing_format(options.image)));
    }
    const Still& still = drawing.draw(replayed.evaluated, shown, camera);
    replayed.timings.add(still.renderer().timings());
    timed(replayed.timings, "write image", [&] { write_image(still.image(), options.image); });
}

void write_timings(const std::string& path, const Timings& timings)
{
    nlohmann::ordered_json stages = nlohmann::ordered_json::array();
    for (const Timings::Stage& stage : timings.stages) {
        stages.push_back({{"name", stage.name}, {"time_ms", stage.time_ms}});
        if (stage.vertices > 0) stages.back()["vertices"] = stage.vertices;
    }
    write_bytes(path, nlohmann::ordered_json{{"stages", stages}}.dump(2) + "\n");
}

// Tells what --epsilon asks for and is not certified. Whether all of it is.
bool certified(const Export& result, const ReplayOptions& options, const Streams& streams)
{
    const std::vector<std::string> open = not_certified(*result.certificate);
    for (const std::string& sentence : open)
        streams.talk << "trivar: " << options.scene.path << ": " << sentence << "\n";
    if (result.certificate->parts.empty() && open.empty())
        streams.talk << "trivar: " << options.scene.path
                     << ": nothing in it lies in a volume, so there is nothing to certify\n";
    return open.empty();
}

bool is_no_glb(const std::string& path)
{
    return extension_of(path) != ".glb";
}

Export exported(const ReplayOptions& options, const ReplayResult& replayed,
                std::optional<double> instances)
{
    return export_of(replayed.evaluated, {replayed.document, options.epsilon.value_or(0),
                                          frame_of(options, replayed.document), options.scene.path,
                                          options.to, instances});
}

// All that is to be written, one file after another.
Status write_all(const ReplayOptions& options, ReplayResult& replayed, const Streams& streams,
                 const Interrupts& interrupts)
{
    Export result, by_instances;
    const bool plain = !options.instances || std::ranges::any_of(options.exports, is_no_glb);
    if (plain && (options.epsilon || !options.exports.empty()))
        result = exported(options, replayed, {});
    if (options.instances)
        by_instances = exported(options, replayed, options.epsilon.value_or(default_tolerance));
    for (const std::string& path : options.exports) {
        go_on(interrupts);
        const bool instances = options.instances && !is_no_glb(path);
        const Export& written = instances ? by_instances : result;
        timed(replayed.timings, "export",
              [&] { write_model(written.model, path, replayed.sources, {instances}); });
        if (instances)
            for (const std::string& words :
                 sentences(written.tiles, options.epsilon.value_or(default_tolerance)))
                streams.talk << "trivar: " << path << ": " << words << "\n";
        if (const std::string words = what_is_lost(written.model, path); !words.empty())
            streams.talk << "trivar: " << path << ": " << words << "\n";
    }
    go_on(interrupts);
    if (!options.image.empty()) draw(options, replayed, streams);
    go_on(interrupts);
    if (!options.timings.empty()) write_timings(options.timings, replayed.timings);
    if (options.digest)
        streams.out << trivar::check_line(digest(replayed.document), digest(replayed.evaluated),
                                          options.frame);
    if (options.epsilon && !certified(plain ? result : by_instances, options, streams))
        return Status::check_failed;
    return replayed.same ? Status::done : Status::check_failed;
}

} // namespace

Status run_replay(const ReplayOptions& options, const Streams& streams)
{
    const Interrupts interrupts;    // before there are threads, so that they know of them too
    still_options(options.drawing); // before any work is done
    relinked_files(options.scene.relinked);
    if (options.epsilon && !(*options.epsilon > 0 && std::isfinite(*options.epsilon)))
        throw WrongUsage("--epsilon: must be a length above 0, in metres");
    if (options.instances && std::ranges::all_of(options.exports, is_no_glb))
        throw WrongUsage("--instances: only a .glb has instances; name one with --export");
    if (!options.image.empty() && !is_line_sheet(options.image)) check_picture_name(options.image);
    for (const std::string& path : options.exports) check_model_name(path);
    check_written(options.exports);
    check_written({options.image, options.timings});
    HandEdits edits = edits_to_keep(options.image);
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    try {
        ReplayResult replayed = replay(options, streams, interrupts);
        replayed.edits = std::move(edits);
        if (!options.scene.keep_going && !lacks(replayed.evaluated, replayed.document).empty()) {
            say_not_whole(options.scene, streams);
            return options.check ? Status::check_failed : Status::rejected;
        }
        const Status status = write_all(options, replayed, streams, interrupts);
        if (options.check && status == Status::done)
            streams.talk << "trivar: " << options.scene.path << ": the check passed\n";
        return status;
    } catch (const Cancelled&) {
        clear_progress(streams);
        streams.talk << "trivar: stopped; files that were not complete were not written\n";
        return Status::interrupted;
    }
}

} // namespace trivar
