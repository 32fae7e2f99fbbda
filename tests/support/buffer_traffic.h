// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <epoxy/gl.h>
#include <limits>
#include <numeric>
#include <vector>

namespace trivar::testing {

// Stands between the program and OpenGL while it lives: what is written to buffers and read from
// them, and a device that has no room. One at a time.
class BufferTraffic {
public:
    BufferTraffic()
        : data_(epoxy_glBufferData),
          part_(epoxy_glBufferSubData),
          read_(epoxy_glGetBufferSubData)
    {
        present_ = this;
        stand_between();
    }
    ~BufferTraffic()
    {
        present_ = nullptr;
        step_aside();
    }
    BufferTraffic(const BufferTraffic&) = delete;
    BufferTraffic& operator=(const BufferTraffic&) = delete;

    std::vector<std::size_t> written;                           // bytes, a write each
    std::size_t read_back = 0;                                  // bytes
    std::size_t room = std::numeric_limits<std::size_t>::max(); // for a buffer

    void forget()
    {
        written.clear();
        read_back = 0;
    }
    std::size_t bytes_written() const
    {
        return std::accumulate(written.begin(), written.end(), std::size_t{0});
    }
    std::size_t largest_written() const
    {
        return written.empty() ? 0 : *std::ranges::max_element(written);
    }

private:
    void step_aside() const
    {
        epoxy_glBufferData = data_;
        epoxy_glBufferSubData = part_;
        epoxy_glGetBufferSubData = read_;
    }
    // Looked up when it is first called, a function of epoxy puts itself back in its place.
    static void stand_between()
    {
        epoxy_glBufferData = [](GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
            const auto bytes = static_cast<std::size_t>(size);
            if (data) present_->written.push_back(bytes);
            present_->step_aside();
            glBufferData(target, bytes > present_->room ? -1 : size, data, usage);
            stand_between();
        };
        epoxy_glBufferSubData = [](GLenum target, GLintptr at, GLsizeiptr size, const void* data) {
            present_->written.push_back(static_cast<std::size_t>(size));
            present_->step_aside();
            glBufferSubData(target, at, size, data);
            stand_between();
        };
        epoxy_glGetBufferSubData = [](GLenum target, GLintptr at, GLsizeiptr size, void* into) {
            present_->read_back += static_cast<std::size_t>(size);
            present_->step_aside();
            glGetBufferSubData(target, at, size, into);
            stand_between();
        };
    }
    static inline BufferTraffic* present_ = nullptr;
    decltype(epoxy_glBufferData) data_;
    decltype(epoxy_glBufferSubData) part_;
    decltype(epoxy_glGetBufferSubData) read_;
};

} // namespace trivar::testing
