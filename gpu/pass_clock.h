// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"

namespace trivar::gpu {

// Times the passes of a picture: by fences on software GL, whose timer queries read zero, by
// timestamp queries elsewhere, read back when asked for.
class PassClock {
public:
    PassClock();
    ~PassClock();
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;

    void start_picture();
    // `vertices`: how many it works on, where that is what it does.
    template <class Body> void pass(const char* name, Body&& body, std::size_t vertices = 0)
    {
        const std::size_t at = begin(name, vertices);
        body();
        end(at);
    }
    const Timings& timings();

private:
    struct Span {
        std::string name;
        std::size_t vertices = 0;
        unsigned from = 0, to = 0; // query objects
        std::chrono::steady_clock::time_point start;
    };
    std::size_t begin(const char* name, std::size_t vertices);
    void end(std::size_t at);
    void forget();
    bool software_;
    std::vector<Span> spans_;
    Timings timings_;
};

} // namespace trivar::gpu
