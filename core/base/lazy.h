// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/mistake.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace trivar {

// A Lazy value is computed when it is first asked for: once for all copies, on any thread. The
// function must be pure, so that its time of running shows in no result, and must not ask for the
// same value. Afterwards an access costs an atomic read.
template <class T> class Lazy {
public:
    Lazy() = default; // must not be asked for its value
    explicit Lazy(std::function<T()> compute) : state_(std::make_shared<State>())
    {
        state_->compute = std::move(compute);
    }

    // Waits where another thread computes the value. An exception of the function is passed on, and
    // the next call tries again.
    const T& operator*() const
    {
        ensure(state_ != nullptr, "a value is asked for that nothing computes");
        State& state = *state_;
        if (state.ready) return *state.value;
        const std::lock_guard lock(state.mutex);
        if (!state.ready) {
            state.value.emplace(state.compute());
            state.compute = nullptr; // frees what the function holds
            state.ready = true;
        }
        return *state.value;
    }
    const T* operator->() const { return &**this; }
    bool ready() const { return state_ && state_->ready; }
    // Whether both are copies of one.
    bool operator==(const Lazy& other) const { return state_ == other.state_; }

private:
    struct State {
        std::mutex mutex;
        std::function<T()> compute;
        std::optional<T> value;
        std::atomic<bool> ready = false;
    };
    std::shared_ptr<State> state_;
};

} // namespace trivar
