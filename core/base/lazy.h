// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cassert>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace trivar {

// A value that is worked out when it is first asked for: once for all copies, whichever threads
// ask. The function must be pure, so that nothing but the time tells when that was, and must not
// ask for this same value. Costs an atomic read once it is there.
template <class T> class Lazy {
public:
    Lazy() = default; // is not asked
    explicit Lazy(std::function<T()> compute) : state_(std::make_shared<State>())
    {
        state_->compute = std::move(compute);
    }

    // Waits where another thread is at it. What the function throws is thrown, and the next call
    // tries again.
    const T& operator*() const
    {
        assert(state_);
        State& state = *state_;
        if (state.ready) return *state.value;
        const std::lock_guard lock(state.mutex);
        if (!state.ready) {
            state.value.emplace(state.compute());
            state.compute = nullptr; // and what it holds
            state.ready = true;
        }
        return *state.value;
    }
    const T* operator->() const { return &**this; }
    bool ready() const { return state_ && state_->ready; }

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
