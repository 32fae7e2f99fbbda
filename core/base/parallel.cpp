// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace trivar {

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body)
{
    const std::size_t blocks = (count + block - 1) / block;
    if (blocks <= 1) {
        if (count > 0) body(0, count);
        return;
    }
    // Every block is a task: they are large, and the automatic partitioner would hand out several
    // at once and leave a thread without any at the end.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, blocks),
        [&](const tbb::blocked_range<std::size_t>& some) {
            for (std::size_t i = some.begin(); i < some.end(); ++i)
                body(i * block, std::min(count, (i + 1) * block));
        },
        tbb::simple_partitioner());
}

struct ThreadLimit::Control {
    tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(new Control{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                               static_cast<std::size_t>(std::max(1, threads)))})
{
}

ThreadLimit::~ThreadLimit() = default;

} // namespace trivar
