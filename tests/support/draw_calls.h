// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace trivar::testing {

// Counts the calls that draw by indices while it lives. One at a time.
class DrawCalls {
public:
    DrawCalls() : single_(epoxy_glDrawElements), instanced_(epoxy_glDrawElementsInstanced)
    {
        present_ = this;
        stand_between();
    }
    ~DrawCalls()
    {
        present_ = nullptr;
        step_aside();
    }
    DrawCalls(const DrawCalls&) = delete;
    DrawCalls& operator=(const DrawCalls&) = delete;

    int count = 0;

private:
    void step_aside() const
    {
        epoxy_glDrawElements = single_;
        epoxy_glDrawElementsInstanced = instanced_;
    }
    // Looked up when it is first called, a function of epoxy puts itself back in its place.
    static void stand_between()
    {
        epoxy_glDrawElements = [](GLenum mode, GLsizei count, GLenum type, const void* from) {
            ++present_->count;
            present_->step_aside();
            glDrawElements(mode, count, type, from);
            stand_between();
        };
        epoxy_glDrawElementsInstanced = [](GLenum mode, GLsizei count, GLenum type,
                                           const void* from, GLsizei instances) {
            ++present_->count;
            present_->step_aside();
            glDrawElementsInstanced(mode, count, type, from, instances);
            stand_between();
        };
    }
    static inline DrawCalls* present_ = nullptr;
    decltype(epoxy_glDrawElements) single_;
    decltype(epoxy_glDrawElementsInstanced) instanced_;
};

} // namespace trivar::testing
