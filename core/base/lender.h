// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <mutex>
#include <optional>
#include <utility>

namespace trivar {

// A Lender gives values away as Refs and gets the memory of one of them back when nobody has it any
// more, so that what is made anew frame by frame takes no new memory. Refs may outlive it, and may
// end on any thread.
template <class T> class Lender {
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
    // Replaces a value by one that came back, whatever that is, if one did.
    void take_back(T& value)
    {
        const std::scoped_lock lock(returned_->mutex);
        if (returned_->value) value = std::move(*returned_->value);
        returned_->value.reset();
    }

private:
    struct Returned {
        std::mutex mutex;
        std::optional<T> value;
    };
    std::shared_ptr<Returned> returned_ = std::make_shared<Returned>();
};

} // namespace trivar
