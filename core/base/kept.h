// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"

#include <type_traits>

namespace trivar {

// A Kept keeps the last few values of a function of one argument, and that argument is their key.
// The function is a lambda that captures nothing, so that a value which it read besides its input
// would not compile. Not thread-safe.
template <class Input, class Output> class Kept {
public:
    explicit Kept(std::size_t most = 3) : values_(most) {}

    // The value of make(input, tools...). `tools` may not change it: other caches, clocks,
    // progress. Inputs are compared by ==. If make() throws, the exception is passed on and nothing
    // changes.
    template <class... Tools>
    const Output& operator()(const Input& input,
                             std::type_identity_t<Output (*)(const Input&, Tools&...)> make,
                             Tools&... tools)
    {
        return values_(input, [&] { return make(input, tools...); });
    }
    // Keeps at most that number of values from now on; the oldest are removed.
    void keep(std::size_t most) { values_.keep(most); }

private:
    Recent<Input, Output> values_;
};

} // namespace trivar
