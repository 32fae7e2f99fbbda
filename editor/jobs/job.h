// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace trivar {

inline constexpr double progress_shown_s = 0.6; // after which working on the scene shows a bar

// Jobs runs long work that is done once: reading a model, writing a file. Jobs run one after
// another on a thread of their own; the function that a job returns is called on the frame thread
// when the job is done. A mistake of Trivar in a job is thrown there, too, once the loss was told.
class Jobs {
public:
    explicit Jobs(std::function<void()> wake);
    ~Jobs(); // cancels the running job and forgets the others
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    using Finish = std::function<void()>;
    struct Job {
        std::string what;                                  // "Reading snake.glb"
        std::function<Finish(const Progress&)> work;       // on the other thread
        std::function<void(const std::string&)> when_lost; // its exception's words, frame thread
    };
    void start(Job job);
    void poll(); // calls what is due; once a frame. An exception of that stops no other job

    struct Status {
        std::string what, stage;
        double fraction = -1, seconds = 0;
    };
    std::optional<Status> status() const; // of the running job
    void cancel();                        // the running job

private:
    void run(const Job& job);
    void next();

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::deque<Job> queue_; // frame thread only
    Status status_;
    double started_s_ = 0;
    bool running_ = false, cancelled_ = false;
    std::optional<Finish> finish_; // there when the running job is over
    std::jthread thread_;
};

} // namespace trivar
