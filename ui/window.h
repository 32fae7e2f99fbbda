// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"

#include <memory>
#include <optional>
#include <string>

namespace trivar::ui {

struct WindowOptions {
    std::string title = "Trivar";
    glm::ivec2 size{1440, 900}; // at scale 1
    double scale = 0;           // of the interface; 0: the environment's TRIVAR_SCALE, else the
                                // monitor's content scale
};

// A Window is a window with an OpenGL core context, current on this thread while it lives: OpenGL
// 4.3, or else what gpu::lacking() accepts. Its loop sleeps until something happens. Throws
// Rejected where there is no display or no such OpenGL.
class Window {
public:
    explicit Window(const WindowOptions& options = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Draws frames when they are due, until a frame asks for the end. Where the graphics card is
    // reset, `forget` must drop everything that was made in the context; then a window with another
    // context replaces this one.
    void run(
        const DrawFrame& body, const std::function<void()>& forget = [] {});

    // A function that wakes the loop for one more frame; any thread may call it while the window
    // lives.
    std::function<void()> waker() const;
    void set_title(const std::string& title);

private:
    struct State;
    std::unique_ptr<State> state_;
};

// The scale that the environment or `asked` (above 0) demands; empty: none.
std::optional<double> scale_override(double asked);

} // namespace trivar::ui
