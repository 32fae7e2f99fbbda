// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/replay.h"

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/document/certificate.h"
#include "core/document/log.h"
#include "core/files/image.h"
#include "core/files/write_model.h"
#include "editor/captions.h"
#include "editor/picture.h"
#include "editor/volume_facts.h"
#include "editor/volume_words.h"
#include "gpu/context.h"
#include "gpu/level.h"
#include "gpu/renderer.h"
#include "gpu/shader_folder.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace trivar {
namespace {

glm::ivec2 picture_size(const std::string& text)
{
    glm::ivec2 size{0};
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        if (height.ec == std::errc{} && height.ptr == end && size.x >= 1 && size.y >= 1 &&
            size.x <= 16384 && size.y <= 16384)
            return size;
    }
    throw WrongUsage("--size " + text + ": must be WIDTHxHEIGHT, such as 1280x720, up to 16384");
}

gpu::Level level_of(const std::string& text)
{
    if (const auto level = gpu::level_named(text)) return *level;
    throw WrongUsage("--quality " + text + ": must be draft, standard or high");
}

gpu::DeformBy deform_of(const std::string& text)
{
    if (const auto by = gpu::deform_named(text)) return *by;
    throw WrongUsage("--deform " + text +
                     ": must be processor, one_phase, two_phases, differences, raised or filtered");
}

Progress shown_progress(const Streams& streams)
{
    if (!streams.terminal) return {};
    return [&talk = streams.talk](double fraction, std::string_view stage) {
        talk << fmt::format("\r\x1b[K{:3.0f} % {}", 100 * fraction, stage) << std::flush;
    };
}

Ref<AssetStore> asset_store(const ReplayOptions& options)
{
    return std::make_shared<const AssetStore>(
        std::filesystem::absolute(options.log).lexically_normal().parent_path().string(),
        relinked_files(options.relinked));
}

// Whoever relinks a file means one that the scene names and one that is there.
void check_relinked(const ReplayOptions& options, const Document& document)
{
    std::set<std::string> named;
    for (const auto& [id, object] : document.objects)
        if (const auto* file = std::get_if<ImportedFile>(&object->source))
            for (std::string& name : AssetStore::names_of(file->path))
                named.insert(std::move(name));
    std::error_code ignored;
    for (const auto& [name, file] : relinked_files(options.relinked)) {
        if (!named.contains(name))
            throw Rejected(
                fmt::format("--set {}={}: the scene names no file {}", name, file, name));
        if (!std::filesystem::exists(file, ignored))
            throw Rejected(fmt::format("--set {}={}: there is no file {}", name, file, file));
    }
}

struct Replayed {
    Document document, shown; // shown: refined as --epsilon wants it
    Evaluated evaluated;
    Timings timings;
    bool same = true; // all that --check looked at
};

void differs(Replayed& replayed, const Streams& streams, const std::string& sentence)
{
    if (replayed.same) streams.talk << "trivar: " << sentence << "\n"; // the first one tells most
    replayed.same = false;
}

void check_line(Replayed& replayed, const LogLine& line, const std::string& name,
                const Document& document, Evaluator& evaluator, const Streams& streams)
{
    const auto compare = [&](const std::string& stored, const std::string& now,
                             std::string_view what) {
        if (stored != now)
            differs(replayed, streams,
                    fmt::format("{}:{}: the {} differs: the file says {}, it is {}", name,
                                line.number, what, stored, now));
    };
    if (!line.digest.empty()) compare(line.digest, digest(document), "scene's digest");
    if (!line.effects.empty())
        compare(line.effects, digest(evaluator(document)), "result's digest");
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

// What is proven of every volume. One that folds may be meant so: this is no check that fails.
void tell_of_volumes(const Replayed& replayed, const Streams& streams)
{
    for (const auto& [id, ref] : replayed.evaluated.objects) {
        if (!ref->placement) continue;
        streams.talk << fmt::format(
            "trivar: {}: its volume {}; it {}\n", object(replayed.document, id).name,
            words_of(*verdicts_of(*ref)), words_of(overlap(ref->placement->volume)));
    }
}

// One thread must give the same bits as many, and nothing may be missing.
void check_result(Replayed& replayed, const ReplayOptions& options, const Streams& streams)
{
    const ThreadLimit one_thread(1);
    Evaluator again(asset_store(options));
    if (digest(again(replayed.shown, frame_of(options, replayed.document))) !=
        digest(replayed.evaluated))
        differs(replayed, streams,
                fmt::format("{}: one thread gives another result than all of them", options.log));
    for (const auto& [id, ref] : replayed.evaluated.objects)
        if ((ref->parts.empty() && !ref->placement) || !ref->rejected.empty())
            differs(replayed, streams,
                    fmt::format("{}: {} is not as it was meant: {}", options.log,
                                object(replayed.document, id).name,
                                ref->notices.empty() ? "it has no shape" : ref->notices.front()));
}

Replayed replay(const ReplayOptions& options, const Streams& streams)
{
    Replayed result;
    std::error_code ignored;
    if (std::filesystem::exists(options.log, ignored) &&
        !std::filesystem::is_regular_file(options.log, ignored))
        throw Rejected(options.log + ": this is no ordinary file");
    const Log log = timed(result.timings, "read log",
                          [&] { return read_log(read_text_file(options.log), options.log); });
    if (!log.notice.empty()) streams.talk << "trivar: " << log.notice << "\n";
    Evaluator evaluator(asset_store(options));
    History history;
    for (const LogLine& line : log.lines) {
        if (options.to > 0 && line.number > options.to) break;
        timed(result.timings, "apply", [&] { apply(history, line, log.name); });
        if (options.check)
            check_line(result, line, log.name, history.document(), evaluator, streams);
    }
    result.document = history.document();
    check_relinked(options, result.document);
    result.shown =
        options.epsilon ? refined_to(result.document, *options.epsilon) : result.document;
    result.evaluated =
        evaluator(result.shown, frame_of(options, result.document), shown_progress(streams));
    if (deform_of(options.deform) == gpu::DeformBy::processor) deform_parts(result.evaluated);
    if (streams.terminal) streams.talk << "\r\x1b[K";
    result.timings.add(result.evaluated.timings);
    for (const auto& [id, ref] : result.evaluated.objects)
        for (const std::string& notice : ref->notices)
            streams.talk << "trivar: " << object(result.document, id).name << ": " << notice
                         << "\n";
    if (options.check) {
        tell_of_volumes(result, streams);
        check_result(result, options, streams);
    }
    return result;
}

void draw(const ReplayOptions& options, Replayed& replayed, const Streams& streams)
{
    const glm::ivec2 size = picture_size(options.size);
    Camera camera = picture_camera(replayed.evaluated, replayed.document, size);
    if (!options.camera.empty()) {
        const auto bookmark = replayed.document.bookmarks.find(options.camera);
        if (bookmark == replayed.document.bookmarks.end())
            throw Rejected(fmt::format("--camera {}: the scene has no point of view of that name",
                                       options.camera));
        camera = ui::reshaped(bookmark->second, size);
    }
    const gpu::HeadlessContext context;
    gpu::Renderer renderer;
    ShownValues values;
    gpu::Picture picture = picture_of(replayed.evaluated, replayed.document, camera, values,
                                      deform_of(options.deform));
    gpu::set_level(picture, level_of(options.quality));
    if (!options.shaders.empty()) picture.shaders = gpu::ShaderFolder(options.shaders).texts(0);
    Image image = renderer.render(picture, size);
    if (!renderer.notice().empty())
        streams.talk << "trivar: deformed by the processor: " << renderer.notice() << "\n";
    if (!renderer.shader_trouble().empty())
        streams.talk << "trivar: a shader of the program itself was taken: "
                     << renderer.shader_trouble() << "\n";
    replayed.timings.add(renderer.timings());
    if (picture.settings.captions)
        image = with_captions(std::move(image), captions_of(replayed.evaluated, replayed.shown),
                              camera, picture.settings);
    timed(replayed.timings, "write image", [&] { write_image(image, options.image); });
}

void write_timings(const std::string& path, const Timings& timings)
{
    nlohmann::ordered_json stages = nlohmann::ordered_json::array();
    for (const Timings::Stage& stage : timings.stages) {
        stages.push_back({{"name", stage.name}, {"time_ms", stage.time_ms}});
        if (stage.vertices > 0) stages.back()["vertices"] = stage.vertices;
    }
    std::ofstream file(path);
    file << nlohmann::ordered_json{{"stages", stages}}.dump(2) << "\n";
    file.flush();
    if (!file) throw Rejected(path + ": the timings cannot be written there");
}

// With a certificate where anything is refined.
Model model_to_write(const Replayed& replayed, const ReplayOptions& options)
{
    Model model = model_of(replayed.evaluated, replayed.document);
    const bool refined = std::ranges::any_of(replayed.evaluated.objects, [](const auto& object) {
        return object.second->refined != nullptr;
    });
    if (!refined && !options.epsilon) return model;
    Certificate certificate = certificate_of(replayed.document, replayed.shown, replayed.evaluated,
                                             model, frame_of(options, replayed.document));
    certificate.tolerance = options.epsilon.value_or(0);
    certificate.lines = options.to;
    certificate.log = std::filesystem::path(options.log).filename().string();
    model.extras = to_json(certificate);
    return model;
}

// Whether all that lies in a volume is within the tolerance that was asked for.
bool certified(const Replayed& replayed, double tolerance)
{
    for (const auto& [id, object] : replayed.evaluated.objects)
        if (object->placement && !object->parts.empty() &&
            !(object->refined && object->refined->bound <= tolerance))
            return false;
    return true;
}

} // namespace

std::map<std::string, std::string> relinked_files(const std::vector<std::string>& settings)
{
    std::map<std::string, std::string> files;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == 0 || equals == std::string::npos || equals + 1 == setting.size())
            throw WrongUsage("--set " + setting + ": must be NAME=FILE");
        files[setting.substr(0, equals)] = setting.substr(equals + 1);
    }
    return files;
}

Status run_replay(const ReplayOptions& options, const Streams& streams)
{
    picture_size(options.size); // before any work is done
    level_of(options.quality);
    deform_of(options.deform);
    relinked_files(options.relinked);
    if (options.epsilon && !(*options.epsilon > 0))
        throw WrongUsage("--epsilon: must be a length above 0, in metres");
    if (!options.image.empty()) check_picture_name(options.image);
    for (const std::string& path : options.exports) check_model_name(path);
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    Replayed replayed = replay(options, streams);
    if (!options.exports.empty()) {
        const Model model = model_to_write(replayed, options);
        for (const std::string& path : options.exports)
            timed(replayed.timings, "export", [&] { write_model(model, path); });
    }
    if (!options.image.empty()) draw(options, replayed, streams);
    if (!options.timings.empty()) write_timings(options.timings, replayed.timings);
    if (options.digest)
        streams.out << check_line(digest(replayed.document), digest(replayed.evaluated));
    if (options.epsilon && !certified(replayed, *options.epsilon)) {
        streams.talk << fmt::format("trivar: {}: not everything is certified to be within {} m\n",
                                    options.log, shortest(*options.epsilon));
        return Status::check_failed;
    }
    if (!replayed.same) return Status::check_failed;
    if (options.check) streams.talk << "trivar: " << options.log << ": as it was meant\n";
    return Status::done;
}

} // namespace trivar
