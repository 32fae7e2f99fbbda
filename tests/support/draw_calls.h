// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace trivar::testing {

// Counts the calls that draw by indices while it lives. One at a time.
class DrawCalls {
public:
    DrawCalls()
        : single_(epoxy_glDrawElements),
          instanced_(epoxy_glDrawElementsInstanced),
          indirect_(epoxy_glDrawElementsIndirect)
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
        epoxy_glDrawElementsIndirect = indirect_;
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
        epoxy_glDrawElementsIndirect = [](GLenum mode, GLenum type, const void* command) {
            ++present_->count;
            present_->step_aside();
            glDrawElementsIndirect(mode, type, command);
            stand_between();
        };
    }
    static inline DrawCalls* present_ = nullptr;
    decltype(epoxy_glDrawElements) single_;
    decltype(epoxy_glDrawElementsInstanced) instanced_;
    decltype(epoxy_glDrawElementsIndirect) indirect_;
};

} // namespace trivar::testing
