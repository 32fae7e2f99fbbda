// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/job.h"
#include "ui/notices.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

struct AnimatedFile;
struct ExportWish;

// A FramesExport writes frames of the scene as it was at the beginning, while work on it continues:
// the files of `trivar export`. Later requests wait for it.
class FramesExport {
public:
    // A notice tells how it ended.
    FramesExport(std::function<void()> wake, ui::Notices& notices)
        : notices_(notices),
          jobs_(std::move(wake))
    {
    }
    void begin(ExportWish wish);
    void poll() { jobs_.poll(); } // once a frame
    void stop() { jobs_.cancel(); }
    std::optional<Worker::Status> status() const { return jobs_.status(); } // while it runs

    // OpenPoints are the points of a file that are not certified, for a person who wants to read
    // them.
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
