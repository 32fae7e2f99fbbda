// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/export.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/certificate/certificate.h"
#include "core/export/animated_files.h"
#include "core/files/file_bytes.h"
#include "editor/command_line/drawing.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

void say(const std::vector<std::string>& sentences, const Streams& streams)
{
    clear_progress(streams);
    for (const std::string& sentence : sentences) streams.talk << "trivar: " << sentence << "\n";
}

Status tell(const AnimatedFile& written, const ExportOptions& options, const Streams& streams)
{
    say(written.lacks, streams);
    say(written.tiles, streams);
    if (!written.left_out.empty()) say({written.left_out}, streams);
    for (const std::string& path : written.files)
        streams.talk << fmt::format("trivar: {}: {}\n", path,
                                    written.frames == 1 ? "one frame"
                                                        : fmt::format("{} frames", written.frames));
    if (!written.certificate) return Status::done;
    const std::vector<std::string> open = not_certified(*written.certificate);
    for (const std::string& sentence : open)
        streams.talk << "trivar: " << options.scene.path << ": " << sentence << "\n";
    say(summary(*written.certificate), streams);
    return open.empty() ? Status::done : Status::check_failed;
}

} // namespace

Status run_export(const ExportOptions& options, const Streams& streams)
{
    const Interrupts interrupts; // before there are threads, so that they know of them too
    relinked_files(options.scene.relinked);
    check_animated_name(options.to);
    check_written({options.to});
    if (options.epsilon && !(*options.epsilon > 0 && std::isfinite(*options.epsilon)))
        throw WrongUsage("--epsilon: must be a length above 0, in metres");
    if (options.instances && extension_of(options.to) != ".usda")
        throw WrongUsage("--instances: of animated files only a .usda has instances; trivar replay "
                         "--instances writes one frame as a .glb with instances");
    constexpr Time any{.first_frame = std::numeric_limits<int>::min(),
                       .last_frame = std::numeric_limits<int>::max()};
    option_value([&] { return frame_range(options.frames, any); });
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    const Log log = scene_log(log_text(options.scene), options.scene.path, streams);
    History history;
    for (const LogLine& line : log.lines) apply(history, line, log.name);
    check_relinked(options.scene, history.document());
    AnimatedScene scene{
        history.document(),          frame_range(options.frames, history.document().time),
        options.epsilon.value_or(0), options.scene.path,
        !options.scene.keep_going,   options.instances};
    const Ref<AssetStore> assets = asset_store(options.scene);
    const SourceFiles sources = kept_sources(options.scene, scene.document, *assets);
    try {
        return tell(
            write_animated(scene, assets, options.to, stoppable(streams, interrupts), sources),
            options, streams);
    } catch (const IncompleteScene& lacking) {
        say(lacking.sentences, streams);
        say_not_whole(options.scene, streams);
        return Status::rejected;
    } catch (const Cancelled&) {
        clear_progress(streams);
        streams.talk << "trivar: stopped; nothing was written\n";
        return Status::interrupted;
    }
}

} // namespace trivar
