// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace trivar::gpu {

// An OpenGL core context without a window, current on the calling thread while it lives: EGL's
// surfaceless platform, else its device platform; 4.3, or else what lacking() is content with.
// Throws Rejected with what was tried.
// `rather_hardware`: where there are graphics cards, one of them, though the surfaceless platform
// may be software: drivers of cards need not have it.
class HeadlessContext {
public:
    explicit HeadlessContext(bool rather_hardware = false);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// What the current context lacks to draw pictures, as the end of a sentence; empty: nothing. It
// takes OpenGL 4.3, or 3.3 with what was made for 4 and offered there too; meshes are then deformed
// by the processor.
std::string lacking();
// What helps where there is too little, as a part of a sentence.
inline constexpr const char* better_opengl =
    "a newer graphics driver helps, or Mesa's software renderer (LIBGL_ALWAYS_SOFTWARE=1)";
// The oldest version that is asked for after 4.3.
inline constexpr int least_gl_version = 33;

// Vendor, renderer and version of the current context, in one line.
std::string describe_context();
// Whether the current context is drawn by the processor (Mesa's llvmpipe and friends).
bool is_software();
// Whether the current context is gone because the graphics card was reset: whatever was made in it
// is lost, and only another context can draw.
bool context_was_lost();

} // namespace trivar::gpu
