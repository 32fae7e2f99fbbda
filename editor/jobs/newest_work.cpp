// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/newest_work.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <utility>

namespace trivar {

NewestWork::NewestWork() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

NewestWork::~NewestWork()
{
    drop();
}

void NewestWork::start(std::function<Finish(const Progress&)> work)
{
    drop();
    newest_ = std::make_shared<std::atomic<bool>>(false);
    const std::lock_guard lock(mutex_);
    waiting_ = Task{std::move(work), newest_};
    something_new_.notify_one();
}

void NewestWork::drop()
{
    if (newest_) *newest_ = true;
    newest_.reset();
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    finished_.reset();
}

bool NewestWork::poll()
{
    std::optional<Finish> finish;
    {
        const std::lock_guard lock(mutex_);
        finish = std::exchange(finished_, std::nullopt);
    }
    if (!finish) return false;
    newest_.reset();
    if (!*finish) return false;
    (*finish)();
    return true;
}

bool NewestWork::busy() const
{
    return newest_ != nullptr;
}

void NewestWork::run(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (something_new_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        const Task task = std::move(*waiting_);
        waiting_.reset();
        lock.unlock();
        Finish finish;
        try {
            finish = task.work([&](double, std::string_view) {
                if (*task.old) throw Cancelled();
            });
        } catch (const std::exception& trouble) { // else it is old, or it cannot be done
            if (is_mistake(trouble))
                finish = [mistake = std::current_exception()] { std::rethrow_exception(mistake); };
        }
        lock.lock();
        if (!*task.old) finished_ = std::move(finish);
    }
}

} // namespace trivar
