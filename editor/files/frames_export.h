// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/animated_files.h"
#include "editor/jobs/job.h"
#include "ui/notices.h"

namespace trivar {

// Frames that are to be written as one file for other programs.
struct ExportWish {
    AnimatedScene scene;
    Ref<AssetStore> assets;
    std::string path; // its ending decides what it is
};

// Writes them, as the scene was when this began, while work on it goes on: the files of `trivar
// export`. Those that are asked for meanwhile come after it.
class FramesExport {
public:
    // How it ended is told by a notice.
    FramesExport(std::function<void()> wake, ui::Notices& notices)
        : notices_(notices),
          jobs_(std::move(wake))
    {
    }
    void begin(ExportWish wish);
    void poll() { jobs_.poll(); } // once a frame
    void stop() { jobs_.cancel(); }
    std::optional<Jobs::Status> status() const { return jobs_.status(); } // while it runs

    // What is not certified of one that a person wants to read about.
    struct OpenPoints {
        std::string file;
        std::vector<std::string> sentences;
    };
    std::optional<OpenPoints> reading;

private:
    void tell(const std::string& path, const AnimatedFile& made, bool named);

    ui::Notices& notices_;
    Jobs jobs_; // last: it stops before the rest goes
};

} // namespace trivar
