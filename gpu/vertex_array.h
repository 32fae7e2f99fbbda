// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/buffer.h"

namespace trivar::gpu {

// A VertexArray is a GL vertex array object: it says which buffers feed which attributes.
class VertexArray {
public:
    VertexArray();
    VertexArray(VertexArray&& other) noexcept;
    VertexArray& operator=(VertexArray&& other) noexcept;
    ~VertexArray();

    // Attribute `location` reads `components` floats every `stride` bytes from `offset` on; with
    // a divisor of 1 it advances per instance.
    void attribute(unsigned location, const Buffer& buffer, int components, int stride,
                   std::size_t offset = 0, unsigned divisor = 0) const;
    // The same for whole numbers without sign, 4 bytes each.
    void integers(unsigned location, const Buffer& buffer, int components, int stride,
                  std::size_t offset = 0, unsigned divisor = 0) const;
    void indices(const Buffer& buffer);
    void bind() const;

private:
    unsigned name_ = 0;
};

} // namespace trivar::gpu
