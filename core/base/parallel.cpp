// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace trivar {
namespace {

// Calls run(i) for every i < count, on any thread.
#ifdef __SANITIZE_THREAD__
// This variant uses no TBB: its library is not instrumented, so the thread sanitizer does not see
// how it orders threads.
void for_each(std::size_t count, const std::function<void(std::size_t)>& run)
{
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) run(i);
    };
    const bool alone =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1;
    auto other = std::async(alone ? std::launch::deferred : std::launch::async, work);
    work();
    other.get();
}
#else
// Each i is a task of its own: blocks are large, and the automatic partitioner would hand out
// several at once and leave a thread idle at the end. The loop is isolated: a thread that waits
// here takes no block of another loop, whose lock it may hold. Blocks compute as the thread that
// calls: without a context they would as it did when it first used TBB, and that may have been in
// Embree, which takes the least numbers for 0.
void for_each(std::size_t count, const std::function<void(std::size_t)>& run)
{
    using Context = tbb::task_group_context;
    Context context(Context::bound, Context::default_traits | Context::fp_settings);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count),
            [&](const tbb::blocked_range<std::size_t>& some) {
                for (std::size_t i = some.begin(); i < some.end(); ++i) run(i);
            },
            tbb::simple_partitioner(), context);
    });
}
#endif

} // namespace

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body)
{
    const std::size_t blocks = (count + block - 1) / block;
    if (blocks <= 1) {
        if (count > 0) body(0, count);
        return;
    }
    for_each(blocks, [&](std::size_t i) { body(i * block, std::min(count, (i + 1) * block)); });
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
