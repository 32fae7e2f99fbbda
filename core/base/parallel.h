// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace trivar {

// Calls body(begin, end) for the consecutive blocks of [0, count), in any order and on any thread.
// Blocks have `block` elements (the last one may have fewer) for any number of threads, so a body
// that writes only its own elements, or one result per block, gives the same bits on any machine.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// While a ThreadLimit lives, parallel_blocks uses at most its number of threads. It lives in main
// and in tests.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace trivar
