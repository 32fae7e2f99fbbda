// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/job.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "editor/jobs/background_evaluator.h"

namespace trivar {

Jobs::Jobs(std::function<void()> wake) : wake_(std::move(wake)) {}

Jobs::~Jobs()
{
    cancel();
    if (thread_.joinable()) thread_.join();
}

void Jobs::start(Job job)
{
    queue_.push_back(std::move(job));
    next();
}

void Jobs::next()
{
    {
        const std::lock_guard lock(mutex_);
        if (running_ || queue_.empty()) return;
        cancelled_ = false;
        status_ = {queue_.front().what, {}, -1, 0};
        started_s_ = now_s();
    }
    if (thread_.joinable()) thread_.join(); // it is over, or it would still be running
    const Job job = std::move(queue_.front());
    queue_.pop_front(); // a job without a thread is not tried again
    thread_ = std::jthread([this, job] { run(job); });
    running_ = true;
}

void Jobs::run(const Job& job)
{
    double last_wake_s = 0;
    const Progress progress = [&](double fraction, std::string_view stage) {
        const std::lock_guard lock(mutex_);
        if (cancelled_) throw Cancelled();
        status_.fraction = fraction;
        status_.stage = stage;
        constexpr double wake_every_s = 0.1;
        if (now_s() - last_wake_s < wake_every_s) return;
        last_wake_s = now_s();
        wake_();
    };
    Finish finish;
    try {
        finish = job.work(progress);
    } catch (const Cancelled&) {
        finish = [] {};
    } catch (const std::exception& trouble) {
        finish = [lost = job.when_lost, words = words_of(trouble),
                  mistake = is_mistake(trouble) ? std::current_exception() : nullptr] {
            if (lost) lost(words);
            if (mistake) std::rethrow_exception(mistake);
        };
    }
    const std::lock_guard lock(mutex_);
    finish_ = std::move(finish);
    wake_();
}

void Jobs::poll()
{
    std::optional<Finish> finish;
    {
        const std::lock_guard lock(mutex_);
        finish = std::exchange(finish_, std::nullopt);
        if (finish) running_ = false;
    }
    if (finish && *finish) (*finish)();
    next(); // in the next frame where this one ended by an exception
}

std::optional<Jobs::Status> Jobs::status() const
{
    const std::lock_guard lock(mutex_);
    if (!running_) return std::nullopt;
    Status status = status_;
    status.seconds = now_s() - started_s_;
    return status;
}

void Jobs::cancel()
{
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
}

} // namespace trivar
