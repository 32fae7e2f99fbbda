// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/worker.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <chrono>
#include <utility>

namespace trivar {

double now_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

Worker::Worker(std::function<void()> wake) : wake_(std::move(wake)) {}

Worker::~Worker()
{
    drop();
}

void Worker::start(Work work, std::string what)
{
    if (!thread_.joinable()) thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
    const std::lock_guard lock(mutex_);
    if (!running_) status_ = {.what = what};
    waiting_ = std::make_shared<Task>(Task{std::move(work), std::move(what)});
    something_new_.notify_one();
}

void Worker::cancel()
{
    const std::lock_guard lock(mutex_);
    if (waiting_) waiting_->cancelled = true; // it begins, and tells that it was stopped
    if (running_) running_->cancelled = true;
}

void Worker::drop()
{
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    if (running_) running_->cancelled = running_->dropped = true;
    finished_.clear();
}

bool Worker::poll()
{
    bool called = false;
    for (;;) {
        Finish finish;
        {
            const std::lock_guard lock(mutex_);
            if (finished_.empty()) return called;
            finish = std::move(finished_.front());
            finished_.pop_front();
        }
        if (!finish) continue;
        called = true;
        finish();
    }
}

bool Worker::is_at_work() const
{
    return waiting_ || (running_ && !running_->dropped);
}

bool Worker::busy() const
{
    const std::lock_guard lock(mutex_);
    return is_at_work() || !finished_.empty();
}

Worker::Status Worker::status() const
{
    const std::lock_guard lock(mutex_);
    Status status = status_;
    status.done = !is_at_work();
    status.seconds = running_ ? now_s() - started_s_ : 0;
    return status;
}

void Worker::hear(Task& task, double fraction, std::string_view stage)
{
    constexpr double wake_every_s = 0.1; // a bar need not move more smoothly
    const std::lock_guard lock(mutex_);
    if (task.cancelled) throw Cancelled();
    status_.fraction = fraction;
    status_.stage = stage;
    if (!wake_ || task.what.empty() || now_s() - woken_s_ < wake_every_s) return;
    woken_s_ = now_s();
    wake_();
}

void Worker::run(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (something_new_.wait(lock, stop, [this] { return waiting_ != nullptr; })) {
        const std::shared_ptr<Task> task = running_ = std::exchange(waiting_, nullptr);
        status_ = {.what = task->what};
        started_s_ = now_s();
        lock.unlock();
        Finish finish;
        try {
            finish = task->work(
                [&](double fraction, std::string_view stage) { hear(*task, fraction, stage); });
        } catch (const std::exception& trouble) {
            if (is_mistake(trouble))
                finish = [mistake = std::current_exception()] { std::rethrow_exception(mistake); };
        }
        task->work = {}; // what it owns goes before anybody waits for the lock
        lock.lock();
        running_.reset();
        if (task->dropped) continue;
        finished_.push_back(std::move(finish));
        if (wake_) wake_();
    }
}

} // namespace trivar
