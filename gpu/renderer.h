// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/mesh/deep_image.h"
#include "gpu/picture.h"
#include "gpu/tiles/tile_counts.h"

#include <memory>
#include <vector>

namespace trivar::gpu {

// A Renderer draws pictures into the current OpenGL context, of a window or headless.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws into a texture of its own, of `size_px` times the picture's scale (the camera's aspect
    // follows it), and returns the texture's name: RGBA8, sRGB-encoded, row 0 at the bottom; valid
    // until the next call. On software GL the ground of a draft may be that of the draft before.
    unsigned draw(const Picture& picture, glm::ivec2 size_px);

    // Draws in pieces, so that a window on a slow machine stays responsive, and nothing of earlier
    // drawings is left. begin() drops an unfinished picture; each advance() draws for about the
    // given time (at least one pass) and tells whether the picture is complete. Until then
    // texture() is the last complete picture.
    void begin(const Picture& picture, glm::ivec2 size_px);
    bool advance(double budget_ms);
    unsigned texture() const;

    Image image() const;          // the last complete picture, read back
    DeepImage deep_image() const; // the same at the depth in which it was drawn

    // Draws as draw() does and reads the picture back.
    Image render(const Picture& picture, glm::ivec2 size_px);

    // The id of the instance under a pixel of the last drawn picture ((0, 0) is top left, at any
    // scale); 0: none.
    int pick(glm::ivec2 p_px);
    // The same, but a curve is picked within `reach_px` of the pixel, unless the surface there lies
    // clearly in front of it.
    int pick_near(glm::ivec2 p_px, double reach_px);
    // The ids of everything that is seen in a rectangle of the picture, ascending; `hi_px` is
    // outside.
    std::vector<int> pick_in(glm::ivec2 lo_px, glm::ivec2 hi_px);

    // The times of the passes of the last picture (by fences on software GL).
    const Timings& timings() const;
    // Returns the counts of the last picture that was begun, or of an earlier one if the graphics
    // card chooses and is not done yet; so it never waits.
    const TileCounts& tile_counts() const;
    // Whether the graphics card chooses which tiles are drawn, or the processor does; the same
    // tiles. Without a call the faster one. Without OpenGL 4.3 it is always the processor.
    void choose_tiles_on_card(bool on_card);
    // Whether the graphics card casts rays through volumes, or the processor does; the same picture
    // but for rounding. Without a call the faster one.
    void cast_on_card(bool on_card);
    // Returns a sentence on the parts of the last picture that were not drawn as asked; empty: all
    // were.
    const std::string& notice() const;
    // A sentence with file and line that says why a shader of the picture is not the given one;
    // empty: all are.
    std::string shader_trouble() const;
    std::size_t uploaded_bytes() const; // memory of meshes and their textures

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar::gpu
