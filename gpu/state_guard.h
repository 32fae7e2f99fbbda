// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace trivar::gpu {

// A StateGuard restores the context's state as ImGui and other guests expect it, after any drawing.
class StateGuard {
public:
    StateGuard();
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    int framebuffer_ = 0;
    std::array<int, 4> viewport_{};
    bool encodes_ = false;
};

} // namespace trivar::gpu
