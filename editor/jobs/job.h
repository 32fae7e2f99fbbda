// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/worker.h"

namespace trivar {

// Jobs runs long work that is done once: reading a model, writing a file. Jobs run one after
// another on a thread of their own; the function that a job returns is called on the frame thread
// when the job is done. A mistake of Trivar in a job is thrown there, too, once the loss was told.
class Jobs {
public:
    explicit Jobs(std::function<void()> wake) : worker_(std::move(wake)) {}

    using Finish = Worker::Finish;
    struct Job {
        std::string what;                                  // "Reading snake.glb"
        Worker::Work work;                                 // on the other thread
        std::function<void(const std::string&)> when_lost; // its exception's words, frame thread
    };
    void start(Job job);
    void poll(); // calls what is due; once a frame. An exception of that stops no other job

    std::optional<Worker::Status> status() const; // of the running job
    void cancel() { worker_.cancel(); }           // the running job

private:
    void next();

    std::deque<Job> queue_;
    Worker worker_; // last: it ends the running job before the rest goes
};

} // namespace trivar
