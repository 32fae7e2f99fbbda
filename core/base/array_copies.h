// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"

#include <functional>
#include <vector>

namespace trivar {

// Empties an array with room for `size` elements; memory that it has is used again. Where that is
// too small there is room for `spare` more, so that an array that grows bit by bit, frame by frame,
// seldom takes new memory.
template <class Value>
void empty_with_room(std::vector<Value>& array, std::size_t size, std::size_t spare)
{
    array.clear();
    if (array.capacity() >= size) return;
    array = {};
    array.reserve(size + spare);
}

// Makes `to` a copy of `from` with room for `more` elements, as empty_with_room() makes it.
template <class Value>
void copy_with_room(const std::vector<Value>& from, std::size_t more, std::vector<Value>& to)
{
    empty_with_room(to, from.size() + more, more);
    to.assign(from.begin(), from.end());
}

// ArrayCopies are jobs on different arrays, done in parallel: most of the cost of a copy is that
// its memory is touched for the first time.
class ArrayCopies {
public:
    void add(std::function<void()> job) { jobs_.push_back(std::move(job)); }
    void run()
    {
        parallel_blocks(jobs_.size(), 1, [&](std::size_t begin, std::size_t) { jobs_[begin](); });
        jobs_.clear();
    }

private:
    std::vector<std::function<void()>> jobs_;
};

} // namespace trivar
