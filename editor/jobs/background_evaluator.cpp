// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/background_evaluator.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <chrono>

namespace trivar {

double now_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

BackgroundEvaluator::BackgroundEvaluator(Ref<AssetStore> assets, std::function<void()> wake,
                                         OnFailure on_failure)
    : evaluator_(std::move(assets), ShutIncisions::vanish, on_failure),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& stop) { work(stop); })
{
}

BackgroundEvaluator::~BackgroundEvaluator()
{
    thread_.request_stop();
    thread_.join();
}

long BackgroundEvaluator::submit(Document document, double frame, bool deform_parts)
{
    const std::lock_guard lock(mutex_);
    waiting_ = Request{std::move(document), frame, deform_parts};
    something_new_.notify_one();
    return ++submitted_;
}

std::optional<BackgroundEvaluator::Result> BackgroundEvaluator::poll()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

void BackgroundEvaluator::submit_view(ViewRequest request)
{
    const std::lock_guard lock(mutex_);
    view_waiting_ = std::move(request);
    something_new_.notify_one();
}

std::optional<BackgroundEvaluator::SeenResult> BackgroundEvaluator::poll_view()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(view_finished_, std::nullopt);
}

BackgroundEvaluator::Status BackgroundEvaluator::status() const
{
    const std::lock_guard lock(mutex_);
    Status status = status_;
    status.busy = status.busy || waiting_.has_value();
    if (status_.busy) status.seconds = now_s() - started_s_;
    return status;
}

void BackgroundEvaluator::cancel()
{
    const std::lock_guard lock(mutex_);
    cancelled_ = status_.busy;
    waiting_.reset();
}

void BackgroundEvaluator::work(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (something_new_.wait(lock, stop, [this] { return waiting_ || view_waiting_; }))
        if (waiting_)
            evaluate(stop, lock);
        else
            refine_view(stop, lock);
}

void BackgroundEvaluator::evaluate(const std::stop_token& stop, std::unique_lock<std::mutex>& lock)
{
    const Request asked = std::move(*waiting_);
    waiting_.reset();
    Result result;
    result.ticket = submitted_;
    status_ = {true, 0, -1, {}};
    started_s_ = now_s();
    cancelled_ = false;
    lock.unlock();
    double last_wake_s = 0;
    const Progress progress = [&](double fraction, std::string_view stage) {
        const std::lock_guard inside(mutex_);
        if (stop.stop_requested() || cancelled_) throw Cancelled();
        status_.fraction = fraction;
        status_.stage = stage;
        constexpr double wake_every_s = 0.1; // a bar need not move more smoothly
        if (now_s() - last_wake_s < wake_every_s) return;
        last_wake_s = now_s();
        wake_();
    };
    try {
        result.evaluated = evaluator_(asked.document, asked.frame, progress);
        if (asked.deform_parts) deform_parts(result.evaluated);
    } catch (const Cancelled&) {
        result.problem = "The picture shows the scene as it was before.";
        result.stopped = true;
    } catch (const std::exception& trouble) {
        result.problem = words_of(trouble);
        if (is_mistake(trouble)) result.mistake = std::current_exception();
    }
    lock.lock();
    status_ = {};
    finished_ = std::move(result);
    wake_();
}

void BackgroundEvaluator::refine_view(const std::stop_token& stop,
                                      std::unique_lock<std::mutex>& lock)
{
    SeenResult result{std::move(*view_waiting_), {}, {}};
    view_waiting_.reset();
    lock.unlock();
    const Progress progress = [&](double, std::string_view) {
        const std::lock_guard inside(mutex_);
        if (stop.stop_requested() || waiting_) throw Cancelled();
    };
    bool done = false;
    try {
        const ViewRequest& request = result.request;
        result.seen =
            view_refining_(request.evaluated, request.camera, request.tolerance_px, progress);
        if (request.deform_parts) deform_parts(result.seen.evaluated);
        done = true;
    } catch (const Cancelled&) {
    } catch (const std::exception& trouble) { // of memory, as it may be: then as they are
        if (is_mistake(trouble)) result.mistake = std::current_exception();
        result.seen.evaluated = result.request.evaluated;
        done = true;
    }
    lock.lock();
    if (done)
        view_finished_ = std::move(result);
    else if (!view_waiting_)
        view_waiting_ = std::move(result.request); // after the document
    wake_();
}

} // namespace trivar
