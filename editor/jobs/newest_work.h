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

// A NewestWork does work on a thread of its own, of which only the newest counts: what comes takes
// the place of what waits, what runs is told to end, and nothing is heard of it any more. For what
// is drawn of a view that may move on. Frame thread only.
class NewestWork {
public:
    NewestWork();
    ~NewestWork(); // ends the work
    NewestWork(const NewestWork&) = delete;
    NewestWork& operator=(const NewestWork&) = delete;

    using Finish = std::function<void()>;
    // The work runs on the other thread and owns what it uses. Its progress, which any thread may
    // call, throws Cancelled once the work is old. Rejected is as if it gave nothing.
    void start(std::function<Finish(const Progress&)> work);
    void drop(); // what runs, waits, or was not taken in
    // Calls what the newest work has returned; true where there was something to call. Throws what
    // the work ended by, where that was a mistake of Trivar.
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
