// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace trivar::gpu {

// A HeadlessContext is an OpenGL core context without a window, current on the calling thread while
// it lives: on EGL's surfaceless platform, else on its device platform; OpenGL 4.3, or else what
// lacking() accepts. Throws Rejected with a list of what was tried. `rather_hardware` prefers a
// graphics card where there is one: the surfaceless platform may be software, because drivers of
// cards need not offer it.
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

// Returns the end of a sentence that says which features for drawing pictures the current context
// lacks; empty: none. It accepts OpenGL 4.3, or 3.3 with extensions for the features of 4; meshes
// are then deformed by the processor.
std::string lacking();
// The part of a sentence that says what helps where something is lacking.
inline constexpr const char* better_opengl =
    "a newer graphics driver helps, or Mesa's software renderer (LIBGL_ALWAYS_SOFTWARE=1)";
// The oldest version that is asked for when there is no 4.3.
inline constexpr int least_gl_version = 33;

// Vendor, renderer and version of the current context, in one line.
std::string describe_context();
// Whether the current context is drawn by the processor (Mesa's llvmpipe and friends).
bool is_software();
// Whether the current context is gone because the graphics card was reset: everything made in it is
// lost, and only another context can draw.
bool context_was_lost();

} // namespace trivar::gpu
