// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"
#include "gpu/context.h"
#include "ui/gui.h"

#include <optional>

namespace trivar::ui {

// HeadlessFrames draws frames without a screen: the same input, the same drawing, an image in place
// of a window. Time stands still between frames and advances by 1/60 s at each.
class HeadlessFrames {
public:
    explicit HeadlessFrames(glm::ivec2 size_px, const ThemeOptions& options = {});
    ~HeadlessFrames();
    HeadlessFrames(const HeadlessFrames&) = delete;
    HeadlessFrames& operator=(const HeadlessFrames&) = delete;

    Input& input() { return gui_.input(); }
    const Theme& theme() const { return gui_.theme(); }
    void frames(int count, const DrawFrame& body);
    // Draws frames as a window would, until no more is due or the limit is reached; returns the
    // number of frames. Waits for later frames are skipped, not slept through.
    int settle(const DrawFrame& body, int limit = 100);
    Image picture() const;           // of the last frame
    void resize(glm::ivec2 size_px); // from the next frame on
    // Draws one pixel of each frame, where nobody looks at its picture; and all of it again.
    void draw_little();
    void draw_whole();
    // Simulates a reset of the graphics card: `forget` drops the body's objects, the context ends
    // and another one begins.
    void lose_context(const std::function<void()>& forget);
    int count() const { return count_; }

private:
    void make_target();
    void drop_target();
    std::optional<gpu::HeadlessContext> context_{std::in_place};
    Gui gui_;
    glm::ivec2 size_px_;
    bool little_ = false;
    ThemeOptions options_;
    unsigned framebuffer_ = 0, color_ = 0;
    double time_s_ = 0;
    int count_ = 0;
    Pace pace_;
};

// The image with the drawing of `body` over it: one frame of an interface of its own, in the
// current OpenGL context, whose state stays, beside any other interface. Throws Rejected where
// fonts are missing.
Image drawn_over(const Image& image, const ThemeOptions& options, const DrawFrame& body);

} // namespace trivar::ui
