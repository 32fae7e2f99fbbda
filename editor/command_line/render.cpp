// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/render.h"

#include "core/base/parallel.h"
#include "core/document/parameters.h"
#include "core/files/pictures/image.h"
#include "editor/record/contact_sheet.h"
#include "editor/record/sequence.h"
#include "editor/record/video.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace trivar {
namespace {

// Words the options of drawing that were asked for.
std::string words_of(const DrawingOptions& drawing)
{
    std::string out = "quality=" + drawing.quality;
    if (!drawing.camera.empty()) out += " camera=" + drawing.camera;
    if (drawing.deform != "processor") out += " deform=" + drawing.deform;
    return out;
}

Sequence sequence_of(const RenderOptions& options)
{
    Sequence out;
    if (!options.sheet.empty()) return out; // one picture
    out.names = option_value([&] { return frame_names(options.out); });
    out.size_px = picture_size(options.drawing.size);
    out.depth = options.depth.value_or(8);
    if (out.names.extension() == ".exr" && options.depth)
        throw WrongUsage("--depth: applies to .png only; .exr always has half floats");
    return out;
}

class Rendering {
public:
    Rendering(const RenderOptions& options, const Streams& streams)
        : options_(options),
          streams_(streams),
          sequence_(sequence_of(options)),
          frames_(option_value([&] { return frames_of(options.frames); })),
          share_(options.shard.empty() ? frames_ : option_value([&] {
              return share_of(frames_, options.shard);
          })),
          assets_(asset_store(options.scene)),
          evaluator_(assets_, ShutIncisions::vanish, OnFailure::leave_out)
    {
        if (!options.sheet.empty()) {
            const glm::ivec2 grid = option_value([&] { return sheet_grid(options.sheet); });
            option_value([&] { check_picture_name(options.out); });
            share_ = evenly_chosen(frames_, grid.x * grid.y);
        }
        const std::string text = log_text(options.scene);
        const Log log = scene_log(text, options.scene.path, streams);
        History history;
        for (const LogLine& line : log.lines) apply(history, line, log.name);
        document_ = history.document();
        check_relinked(options.scene, document_);
        check_frames(frames_, document_.time);
        check_camera(options_.drawing, document_);
        check_sources();
        if (!options.sheet.empty()) return;
        sequence_.log = digest_of_log(text);
        sequence_.settings =
            sequence_settings(words_of(options.drawing), document_, *assets_,
                              shaders_of(options.drawing), options.scene.keep_going);
    }

    Status run(const Interrupts& interrupts)
    {
        Drawing drawing(options_.drawing, streams_);
        const std::optional<Camera> fixed = camera_of_all(drawing);
        make_folder_of(sequence_.names.path(frames_.front()));
        if (!options_.video.empty()) make_folder_of(options_.video);
        const auto start = std::chrono::steady_clock::now();
        int done = 0, drawn = 0;
        PictureReader reader;
        for (const int frame : share_) {
            if (!options_.resume || !sequence_.has(frame, reader)) {
                const std::chrono::duration<double> passed =
                    std::chrono::steady_clock::now() - start;
                tell(done, drawn, passed.count());
                sequence_.writer(frame, drawn_frame(drawing, frame, fixed))();
                ++drawn;
            }
            ++done;
            if (interrupts.came() && done < static_cast<int>(share_.size())) {
                clear_progress(streams_);
                streams_.talk << fmt::format("trivar: stopped after frame {}: {} of {} are there; "
                                             "--resume draws the others\n",
                                             frame, done, share_.size());
                return Status::interrupted;
            }
        }
        clear_progress(streams_);
        if (const int gone = sequence_.gone(share_); gone > 0)
            throw Rejected(fmt::format(
                "{}: {} of {} frames were deleted while the others were drawn; --resume draws them",
                options_.out, gone, share_.size()));
        streams_.talk << fmt::format("trivar: {} frame{}, {} drawn\n", share_.size(),
                                     share_.size() == 1 ? "" : "s", drawn);
        return Status::done;
    }

    Status write_sheet(const Interrupts& interrupts)
    {
        Drawing drawing(options_.drawing, streams_);
        const std::optional<Camera> fixed = camera_of_all(drawing);
        std::vector<Image> pictures;
        for (const int frame : share_) {
            if (interrupts.came()) {
                streams_.talk << fmt::format("trivar: stopped; {} was not written\n", options_.out);
                return Status::interrupted;
            }
            pictures.push_back(drawn_frame(drawing, frame, fixed).image());
        }
        write_image(contact_sheet(pictures, sheet_grid(options_.sheet).x), options_.out);
        return Status::done;
    }

    Status write_video(const Interrupts& interrupts) const
    {
        PictureReader reader;
        const auto missing = static_cast<int>(std::ranges::count_if(
            frames_, [&](int frame) { return !sequence_.has(frame, reader); }));
        if (missing > 0) {
            streams_.talk << fmt::format("trivar: {}: is made when all frames are there; {} of {} "
                                         "are not\n",
                                         options_.video, missing, frames_.size());
            return Status::done;
        }
        std::vector<std::string> pictures;
        for (const int frame : frames_) pictures.push_back(sequence_.names.path(frame));
        const int step = frames_.size() > 1 ? frames_[1] - frames_[0] : 1;
        try {
            trivar::write_video(pictures, document_.time.frames_per_second / step, options_.video,
                                stoppable(streams_, interrupts));
            clear_progress(streams_);
            return Status::done;
        } catch (const Cancelled&) {
            clear_progress(streams_);
            streams_.talk << fmt::format("trivar: stopped; {} was not written\n", options_.video);
            return Status::interrupted;
        }
    }

private:
    // Refuses to write over a file from which the scene is made.
    void check_sources() const
    {
        const SourceFiles sources = kept_sources(options_.scene, document_, *assets_);
        if (!options_.video.empty()) sources.check(options_.video);
        if (!options_.sheet.empty()) return sources.check(options_.out);
        for (const int frame : share_) sources.check(sequence_.names.path(frame));
    }
    // Where no view is kept it is one for all of them: that of the first frame.
    std::optional<Camera> camera_of_all(const Drawing& drawing)
    {
        const int first = document_.time.first_frame;
        const Document at_first = document_at(document_, first);
        if (!options_.drawing.camera.empty() || at_first.kept_views.contains("picture")) return {};
        return drawing.camera(evaluated_at(first), at_first);
    }
    const Still& drawn_frame(Drawing& drawing, int frame, const std::optional<Camera>& fixed)
    {
        const Document now = document_at(document_, frame);
        const Evaluation evaluated = evaluated_at(frame);
        const Camera camera = fixed ? *fixed : drawing.camera(evaluated, now);
        return drawing.draw(evaluated, now, camera, sequence_.deep());
    }
    Evaluation evaluated_at(int frame)
    {
        Evaluation out = evaluator_(document_, frame);
        for (const auto& [id, ref] : out.objects)
            for (const std::string& notice : ref->notices) {
                const std::string sentence = object(document_, id).name + ": " + notice;
                if (!said_.insert(sentence).second) continue;
                clear_progress(streams_);
                streams_.talk << "trivar: " << sentence << "\n";
            }
        check_whole(options_.scene, out, document_);
        return out;
    }
    void tell(int done, int drawn, double seconds) const
    {
        if (!streams_.terminal) return;
        const int all = static_cast<int>(share_.size());
        const std::string left = time_left(drawn, all - done + drawn, seconds);
        streams_.talk << fmt::format("\r\x1b[K{} of {}{}{}", done + 1, all,
                                     left.empty() ? "" : ", ", left)
                      << std::flush;
    }

    const RenderOptions& options_;
    const Streams& streams_;
    Sequence sequence_;
    std::vector<int> frames_, share_;
    Document document_;
    Ref<AssetStore> assets_;
    Evaluator evaluator_;
    std::set<std::string> said_;
};

} // namespace

Status run_render(const RenderOptions& options, const Streams& streams)
{
    const Interrupts interrupts;    // before there are threads, so that they know of them too
    still_options(options.drawing); // before any work is done
    relinked_files(options.scene.relinked);
    if (!options.video.empty()) check_video(options.video);
    check_written({options.video, options.sheet.empty() ? "" : options.out});
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    Rendering rendering(options, streams);
    try {
        if (!options.sheet.empty()) return rendering.write_sheet(interrupts);
        const Status status = rendering.run(interrupts);
        if (status != Status::done || options.video.empty()) return status;
    } catch (const IncompleteScene&) { // what was said
        say_not_whole(options.scene, streams);
        return Status::rejected;
    }
    return rendering.write_video(interrupts);
}

} // namespace trivar
