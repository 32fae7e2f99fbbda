// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

// Timings holds the time that each named stage took. It lies beside a result and never influences
// it.
struct Timings {
    struct Stage {
        std::string name; // the same name in the overlay, the benchmark and the docs
        double time_ms = 0;
        // number of vertices that the stage worked on, where it works on vertices
        std::size_t vertices = 0;
    };
    std::vector<Stage> stages; // in the order of their first run; one entry per name

    void add(std::string name, double time_ms, std::size_t vertices = 0)
    {
        for (Stage& stage : stages)
            if (stage.name == name) {
                stage.time_ms += time_ms;
                stage.vertices += vertices;
                return;
            }
        stages.push_back({std::move(name), time_ms, vertices});
    }
    void add(const Timings& other)
    {
        for (const Stage& stage : other.stages) add(stage.name, stage.time_ms, stage.vertices);
    }
};

// Runs body(), adds its time to `timings` under the name, and returns what body returns.
template <class Body> decltype(auto) timed(Timings& timings, std::string name, Body&& body)
{
    struct Watch {
        Timings& timings;
        std::string name;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        ~Watch()
        {
            const std::chrono::duration<double, std::milli> spent =
                std::chrono::steady_clock::now() - start;
            timings.add(std::move(name), spent.count());
        }
    } watch{timings, std::move(name)};
    return body();
}

} // namespace trivar
