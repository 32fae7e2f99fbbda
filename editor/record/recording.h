// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/job.h"
#include "gpu/shader_source.h"
#include "gpu/texture.h"
#include "ui/frame.h"
#include "ui/notices.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace trivar {

class Still;
struct RecordingWish;

// Frames of a scene, as it was when this began, drawn into files while work on it goes on: each is
// evaluated on another thread, drawn a piece a frame of the window, and written as `trivar render`
// writes it. Frames that are there already are left as they are, so a recording that was stopped,
// here or there, is continued by another one.
class Recording {
public:
    // How it ended is told by a notice.
    Recording(std::function<void()> wake, ui::Notices& notices);
    ~Recording();
    bool running() const { return run_ != nullptr; }
    void begin(RecordingWish wish); // in place of one that runs
    void stop();
    // Once a frame, in the window's context.
    void advance(ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders = {});
    void forget_gpu(); // before the context goes; the frame at hand is drawn anew

    struct Status {
        std::string what, left; // "Recording 12 of 240", "3 s per frame, 3 min left"
        double fraction = 0;
    };
    Status status() const; // while it runs
    // The last frame that was drawn here, small; null: none yet.
    const gpu::Texture2D* last() const { return last_ ? &*last_ : nullptr; }

private:
    enum class Doing { evaluating, drawing, writing, filming };
    struct Run;
    // Does work on the other thread, and then on this one, while it is still this run.
    void start(Doing doing, std::function<void(Run&, const Progress&)> work,
               void (Recording::*then)());
    void next();  // finds the next frame that is not there, and evaluates it
    void draw();  // begins to
    void write(); // what was drawn
    void film();
    void end(ui::NoticeKind kind, const std::string& title, const std::string& body);

    ui::Notices& notices_;
    std::shared_ptr<Run> run_;
    Doing doing_ = Doing::evaluating;
    std::unique_ptr<Still> still_;
    Ref<gpu::ShaderTexts> shaders_;
    double began_s_ = 0, now_s_ = 0; // on the window's clock
    std::optional<gpu::Texture2D> last_;
    Jobs jobs_; // last: it stops before the rest goes
};

} // namespace trivar
