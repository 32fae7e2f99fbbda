// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/recording.h"

#include "core/base/rejected.h"
#include "core/document/parameters.h"
#include "core/files/pictures/image.h"
#include "core/scene/files_read.h"
#include "editor/picture/picture.h"
#include "editor/picture/stored_pictures.h"
#include "editor/record/recording_wish.h"
#include "editor/record/sequence.h"
#include "editor/record/video.h"
#include "editor/words/file_words.h"
#include "ui/camera_control.h"

#include <atomic>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <utility>

namespace trivar {

// A Run is what the jobs of one recording share with it; a job that ends after it finds another
// run.
struct Recording::Run {
    explicit Run(RecordingWish what) : wish(std::move(what)), evaluator(wish.assets) {}
    RecordingWish wish;
    Evaluator evaluator; // of the other thread
    Document shown;      // in the frame at hand
    Evaluation evaluated;
    Camera camera;
    LineDrawer drawer;
    LineScene line_scene; // in that frame
    Ref<SceneLines> lines;
    std::function<void()> writer;
    std::atomic<std::size_t> at = 0; // of the frames; before it all are there
    int drawn = 0;
    bool prepared = false;
    int frame() const { return wish.frames[at]; }
    bool all_there() const { return at == wish.frames.size(); }
    std::string folder() const { return file_name(wish.sequence.names.folder()); }
};

namespace {

constexpr int last_px = 320; // across the picture of the last frame

Image small_image(const Still& still, bool deep)
{
    if (!deep) return shrunk(still.image(), last_px);
    const DeepImage image = still.deep_image();
    Image out;
    out.size_px = image.size_px;
    for (const std::uint16_t each : image.rgba)
        out.rgba.push_back(static_cast<std::uint8_t>(each >> 8));
    return shrunk(out, last_px);
}

std::string frames_words(std::size_t count)
{
    return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
}

} // namespace

Recording::Recording(std::function<void()> wake, ui::Notices& notices)
    : notices_(notices),
      jobs_(std::move(wake))
{
}

Recording::~Recording() = default;

void Recording::begin(RecordingWish wish)
{
    jobs_.cancel();
    run_ = std::make_shared<Run>(std::move(wish));
    last_.reset();
    began_s_ = now_s_;
    next();
}

void Recording::start(Doing doing, std::function<void(Run&, const Progress&)> work,
                      void (Recording::*then)())
{
    doing_ = doing;
    const std::shared_ptr<Run> run = run_;
    jobs_.start({"Recording",
                 [this, run, then, work = std::move(work)](const Progress& progress) {
                     work(*run, progress);
                     return [this, run, then] {
                         if (run == run_) (this->*then)();
                     };
                 },
                 [this, run](const std::string& why) {
                     if (run == run_) end(ui::NoticeKind::error, "The recording has ended", why);
                 }});
}

void Recording::next()
{
    start(
        Doing::evaluating,
        [shaders = shaders_](Run& run, const Progress& progress) {
            RecordingWish& wish = run.wish;
            if (!std::exchange(run.prepared, true)) {
                const SourceFiles sources = source_files(wish.document, *wish.assets, {});
                for (const int frame : wish.frames) sources.check(wish.sequence.names.path(frame));
                if (!wish.video.empty()) sources.check(wish.video);
                make_folder_of(wish.sequence.names.path(wish.frames.front()));
                if (!wish.video.empty()) make_folder_of(wish.video);
                wish.sequence.settings = sequence_settings(std::move(wish.sequence.settings),
                                                           wish.document, *wish.assets, shaders);
            }
            PictureReader reader;
            while (!run.all_there() && wish.sequence.has(run.frame(), reader)) {
                report(progress, 0, "frames that are there");
                ++run.at;
            }
            if (run.all_there()) return;
            run.shown = document_at(wish.document, run.frame());
            run.evaluated = run.evaluator(wish.document, run.frame(), progress);
            deform_parts(run.evaluated);
            const glm::ivec2 size_px = wish.sequence.size_px;
            run.camera = wish.camera ? ui::reshaped(*wish.camera, glm::dvec2(size_px))
                                     : picture_camera(run.evaluated, run.shown, size_px);
            run.line_scene = line_scene(run.evaluated, run.shown, run.camera);
            run.lines = make_ref(run.drawer(run.line_scene, {.progress = progress}));
        },
        &Recording::draw);
}

void Recording::draw()
{
    if (run_->all_there()) return film();
    const RecordingWish& wish = run_->wish;
    if (!still_) still_ = std::make_unique<Still>();
    still_->give_lines(run_->line_scene, run_->lines);
    still_->begin(run_->evaluated, run_->shown, run_->camera,
                  {.size_px = wish.sequence.size_px,
                   .level = wish.level,
                   .deep = wish.sequence.deep(),
                   .shaders = shaders_});
    doing_ = Doing::drawing;
}

void Recording::write()
{
    const Sequence& sequence = run_->wish.sequence;
    const Image small = small_image(*still_, sequence.deep());
    last_.emplace(GL_RGBA8, small.size_px, true);
    last_->write_rgba(small.rgba);
    run_->writer = sequence.writer(run_->frame(), *still_);
    ++run_->drawn;
    start(
        Doing::writing,
        [](Run& run, const Progress&) {
            run.writer();
            ++run.at;
        },
        &Recording::next);
}

void Recording::film()
{
    still_.reset();
    if (const int gone = run_->wish.sequence.gone(run_->wish.frames); gone > 0)
        return end(ui::NoticeKind::error, "Frames were deleted",
                   fmt::format("{} were deleted from {} while the others were rendered. Record "
                               "again to render them.",
                               frames_words(gone), run_->folder()));
    const auto finish = [](Recording& self) {
        const Run& run = *self.run_;
        const std::string& video = run.wish.video;
        self.end(ui::NoticeKind::good, "The recording is finished",
                 fmt::format("{} are in {}{}.", frames_words(run.at), run.folder(),
                             video.empty() ? "" : ", and " + file_name(video)));
    };
    if (run_->wish.video.empty() || doing_ == Doing::filming) return finish(*this);
    start(
        Doing::filming,
        [](Run& run, const Progress& progress) {
            const RecordingWish& wish = run.wish;
            std::vector<std::string> pictures;
            for (const int frame : wish.frames) pictures.push_back(wish.sequence.names.path(frame));
            const int step = wish.frames.size() > 1 ? wish.frames[1] - wish.frames[0] : 1;
            write_video(pictures, wish.document.time.frames_per_second / step, wish.video,
                        progress);
        },
        &Recording::film);
}

void Recording::end(ui::NoticeKind kind, const std::string& title, const std::string& body)
{
    notices_.say(kind, title, body, "picture");
    still_.reset();
    run_.reset();
}

void Recording::stop()
{
    if (!run_) return;
    jobs_.cancel();
    end(ui::NoticeKind::good, "The recording was stopped",
        fmt::format("{} are in {}. Record again to continue.", frames_words(run_->at),
                    run_->folder()));
}

void Recording::forget_gpu()
{
    still_.reset();
    last_.reset();
    if (run_ && doing_ == Doing::drawing) next();
}

Recording::Status Recording::status() const
{
    const Run& run = *run_;
    const std::size_t all = run.wish.frames.size(), at = run.at;
    Status out;
    out.fraction = static_cast<double>(at) / static_cast<double>(all);
    if (doing_ == Doing::filming) {
        out.what = "Writing " + file_name(run.wish.video);
        if (const auto job = jobs_.status()) out.fraction = job->fraction;
        return out;
    }
    out.what = fmt::format("Recording {} of {}", std::min(at + 1, all), all);
    const double passed_s = now_s_ - began_s_;
    if (run.drawn == 0) return out;
    const auto left = static_cast<int>(all - at);
    out.left = time_left(run.drawn, run.drawn + left, passed_s);
    const double each_s = passed_s / run.drawn;
    const std::string each = each_s < 10 ? fmt::format("{:.1f} s per frame", each_s)
                                         : fmt::format("{:.0f} s per frame", each_s);
    out.left = out.left.empty() ? each : each + ", " + out.left;
    return out;
}

void Recording::advance(ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders)
{
    constexpr double budget_ms = 40; // as for the window's own picture
    now_s_ = frame.time_s;
    shaders_ = shaders;
    try {
        jobs_.poll();
        if (!run_ || doing_ != Doing::drawing) return;
        frame.again_in(0);
        if (still_->advance(budget_ms)) write();
    } catch (const Rejected& error) {
        end(ui::NoticeKind::error, "The recording has ended", error.what());
    }
}

} // namespace trivar
