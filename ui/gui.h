// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tooltip.h"

#include <memory>

namespace trivar::ui {

// A Gui is ImGui on the current OpenGL context, of a window or headless. It lives as long as the
// context stays current on this thread.
class Gui {
public:
    explicit Gui(const ThemeOptions& options = {});
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    Input& input() { return input_; }
    const Theme& theme() const { return theme_; }
    void set_theme(const ThemeOptions& options); // between frames only

    // Drops all GPU objects; the next frame makes them again in the context that is current then.
    void forget_gpu();

    // One frame into the bound framebuffer: input, body, pixels.
    Frame frame(glm::ivec2 size_px, double time_s, bool close_asked, const DrawFrame& body);

private:
    struct Contexts; // made first and destroyed last
    std::unique_ptr<Contexts> contexts_;
    Theme theme_;
    Input input_;
    Tooltips tooltips_;
    friend Input& hands();
    friend Tooltips& tooltips();
    double last_time_s_ = -1;
    std::vector<unsigned> popups_; // popups that were open at the last frame
    bool by_key_ = false;          // the last input was a key press
};

} // namespace trivar::ui
