// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <mutex>
#include <optional>
#include <utility>

namespace trivar {

// A RefPool is a pool of one: it gives values away as Refs and gets the memory of one of them back
// when nobody has it any more, so that values made anew frame by frame take no new memory. Refs may
// outlive it, and may end on any thread.
template <class T> class RefPool {
public:
    Ref<T> lend(T value)
    {
        return Ref<T>(new T(std::move(value)), [to = std::weak_ptr<Returned>(returned_)](T* old) {
            const std::unique_ptr<T> value_back(old);
            const std::shared_ptr<Returned> there = to.lock();
            if (!there) return;
            const std::scoped_lock lock(there->mutex);
            if (!there->value) there->value = std::move(*value_back);
        });
    }
    // The value of a Ref that nobody has any more; none: all are in use.
    std::optional<T> take_back()
    {
        const std::scoped_lock lock(returned_->mutex);
        return std::exchange(returned_->value, std::nullopt);
    }

private:
    struct Returned {
        std::mutex mutex;
        std::optional<T> value;
    };
    std::shared_ptr<Returned> returned_ = std::make_shared<Returned>();
};

} // namespace trivar
