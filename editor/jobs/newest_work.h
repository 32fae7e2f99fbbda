// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace trivar {

// A NewestWork does work on a thread of its own, of which only the newest counts: a new task
// replaces the waiting one, the running one is told to end, and its result is dropped. It suits
// pictures of a view that may move on. Frame thread only.
class NewestWork {
public:
    NewestWork();
    ~NewestWork(); // ends the work
    NewestWork(const NewestWork&) = delete;
    NewestWork& operator=(const NewestWork&) = delete;

    using Finish = std::function<void()>;
    // Starts work on the other thread, which owns its input. Its progress, which any thread may
    // call, throws Cancelled once the work is old. A Rejected counts as no result.
    void start(std::function<Finish(const Progress&)> work);
    void drop(); // what runs, waits, or was not taken in
    // Calls the function that the newest work has returned; true if there was one. Throws the
    // exception that ended the work, if that was a mistake of Trivar.
    bool poll();
    bool busy() const; // something runs or waits that was not dropped

private:
    struct Task {
        std::function<Finish(const Progress&)> work;
        std::shared_ptr<std::atomic<bool>> old; // nobody waits for it any more
    };
    void run(const std::stop_token& stop);

    std::shared_ptr<std::atomic<bool>> newest_; // of the task that counts; null: none does
    mutable std::mutex mutex_;
    std::condition_variable_any something_new_;
    std::optional<Task> waiting_;
    std::optional<Finish> finished_;
    std::jthread thread_; // last: it stops before the rest goes
};

} // namespace trivar
