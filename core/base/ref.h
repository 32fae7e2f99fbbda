// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace trivar {

// A Ref is a shared value that is never written through. Equal pointers mean equal values, so a
// pointer comparison is the test for "unchanged".
template <class T> using Ref = std::shared_ptr<const T>;

template <class T> Ref<T> make_ref(T value)
{
    return std::make_shared<const T>(std::move(value));
}

} // namespace trivar
