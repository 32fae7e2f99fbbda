// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace trivar {

double now_s();                                 // seconds on a steady clock
inline constexpr double progress_shown_s = 0.6; // after which working on the scene shows a bar

// A Worker does work on a thread of its own, so that the window never waits. One piece of work
// runs and one waits, whose place the next takes: only the newest counts. What the work gives is
// called on the frame thread, which alone calls the functions of a Worker.
class Worker {
public:
    using Finish = std::function<void()>; // empty: there is nothing to take in
    // The work owns what it uses. Its progress, which any thread may call, throws Cancelled where
    // the work is told to end. The work may end by an exception as well: a mistake of Trivar is
    // thrown by poll(), any other gives nothing.
    using Work = std::function<Finish(const Progress&)>;

    // The other thread calls `wake` when work is done, and ten times a second while it goes on.
    explicit Worker(std::function<void()> wake = {});
    ~Worker(); // as drop(), and waits for what runs
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // `what`: its name for the user; without one its progress wakes nobody.
    void start(Work work, std::string what = {});
    void cancel(); // the progress of what runs and of what waits throws Cancelled
    void drop();   // ends what runs, forgets what waits, and nothing is heard of either any more
    // Calls what finished work has given; true where there was something to call. Once a frame.
    bool poll();

    bool busy() const; // something waits, runs, or was not taken in, of what was not dropped
    struct Status {    // of the newest work that runs or ran
        std::string what = {}, stage = {};
        double fraction = -1, seconds = 0;
        bool done = true; // nothing runs or waits
    };
    Status status() const;

private:
    struct Task {
        Work work;
        std::string what;
        bool cancelled = false, dropped = false;
    };
    void run(const std::stop_token& stop);
    void hear(Task& task, double fraction, std::string_view stage);
    bool is_at_work() const; // locked

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any something_new_;
    std::shared_ptr<Task> waiting_, running_; // null: none
    std::deque<Finish> finished_;
    Status status_;
    double started_s_ = 0, woken_s_ = 0;
    std::jthread thread_; // from the first work on; last: it stops before the rest goes
};

} // namespace trivar
