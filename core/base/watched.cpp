// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/watched.h"

#include "core/base/rejected.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace trivar {
namespace {

constexpr std::chrono::milliseconds between_looks{20};

struct WatchedWork {
    std::mutex mutex;
    std::condition_variable ended;
    double fraction = 0;
    std::string stage;
    bool stop = false, done = false;
    std::exception_ptr trouble;
};

} // namespace

void run_watched(std::function<void(const Progress&)> work, const Progress& progress)
{
    if (!progress) return work(progress);
    const auto state = std::make_shared<WatchedWork>();
    std::thread([state, work = std::move(work)]() mutable {
        const Progress inner = [&](double fraction, std::string_view stage) {
            const std::lock_guard guard(state->mutex);
            if (state->stop) throw Cancelled();
            state->fraction = fraction;
            state->stage = stage;
        };
        std::exception_ptr trouble;
        try {
            work(inner);
        } catch (...) {
            trouble = std::current_exception();
        }
        work = nullptr; // what it holds goes before anyone goes on
        const std::lock_guard guard(state->mutex);
        state->trouble = std::move(trouble);
        state->done = true;
        state->ended.notify_all();
    }).detach();
    std::unique_lock lock(state->mutex);
    for (bool done = false; !done;) { // the last look is after the end, so that all is reported
        state->ended.wait_for(lock, between_looks, [&] { return state->done; });
        done = state->done;
        const double fraction = state->fraction;
        const std::string stage = state->stage;
        lock.unlock();
        try {
            progress(fraction, stage);
        } catch (...) {
            lock.lock();
            state->stop = true;
            throw;
        }
        lock.lock();
    }
    if (state->trouble) std::rethrow_exception(std::exchange(state->trouble, nullptr));
}

} // namespace trivar
