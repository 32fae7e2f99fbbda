// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/mesh/deep_image.h"
#include "gpu/picture.h"

#include <memory>
#include <vector>

namespace trivar::gpu {

// Draws pictures into the current OpenGL context, a window's or a headless one alike.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws into a texture of its own, `size_px` large times the picture's scale (the camera's
    // aspect follows it), and returns that texture's name: RGBA8, sRGB-encoded, row 0 at the
    // bottom; valid till the next call. On software GL the ground of a draft may be as it was in
    // the one before.
    unsigned draw(const Picture& picture, glm::ivec2 size_px);

    // The same in pieces, so that a window on a slow machine stays awake, and with nothing left of
    // what was drawn before: begin() drops what was begun, each advance() draws on for about so
    // long (a pass at least) and tells whether the picture is whole. Until then texture() stays
    // the last whole picture.
    void begin(const Picture& picture, glm::ivec2 size_px);
    bool advance(double budget_ms);
    unsigned texture() const;

    Image image() const;          // the last whole picture, read back
    DeepImage deep_image() const; // the same, as finely as it was drawn

    // The same as draw(), read back.
    Image render(const Picture& picture, glm::ivec2 size_px);

    // The id of the instance under a pixel of the last picture drawn (0, 0 top left, whatever its
    // scale); 0: none.
    int pick(glm::ivec2 p_px);
    // The same; a curve is picked as far beside it as that, unless what is seen at the pixel lies
    // clearly in front of it.
    int pick_near(glm::ivec2 p_px, double reach_px);
    // The ids of all that is seen in a rectangle of it, ascending; `hi_px` is outside.
    std::vector<int> pick_in(glm::ivec2 lo_px, glm::ivec2 hi_px);

    // How long the passes of the last picture took (by fences on software GL).
    const Timings& timings() const;
    // What of the last picture was not drawn as it was asked, as a sentence; empty: nothing.
    const std::string& notice() const;
    // Why some shader of the picture is not the one that was given with it, as a sentence with file
    // and line; empty: all are.
    std::string shader_trouble() const;
    std::size_t uploaded_bytes() const; // of meshes and their textures

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar::gpu
