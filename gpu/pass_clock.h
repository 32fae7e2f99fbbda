// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"

namespace trivar::gpu {

// A PassClock measures the passes of a picture: by fences on software GL, whose timer queries read
// zero, elsewhere by timestamp queries, which are read back when the times are asked for.
class PassClock {
public:
    PassClock();
    ~PassClock();
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;

    void start_picture();
    // `vertices` is the number of vertices that the pass works on, where it works on vertices.
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
