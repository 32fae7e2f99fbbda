// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace trivar {

// Runs work on a thread of its own and calls the progress here, on the thread of the caller, every
// 20 milliseconds and whenever the work has ended, however seldom the work itself reports. Where
// the progress throws (Cancelled), this throws it at once; the work then meets Cancelled when it
// next reports, on whichever thread, and ends without anyone waiting. So it must own all that it
// uses. What the work throws is thrown here. With an empty progress it runs right here.
void run_watched(std::function<void(const Progress&)> work, const Progress& progress);

// The same for work that makes a value.
template <class Work> auto watched(Work work, const Progress& progress)
{
    using Made = decltype(work(progress));
    const auto made = std::make_shared<std::optional<Made>>();
    run_watched([made, work = std::move(work)](const Progress& inner) { *made = work(inner); },
                progress);
    return std::move(**made);
}

} // namespace trivar
