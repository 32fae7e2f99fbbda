// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/buffer.h"

#include <epoxy/gl.h>
#include <utility>

namespace trivar::gpu {

Buffer::Buffer(Buffer&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      bytes_(std::exchange(other.bytes_, 0))
{
}

Buffer& Buffer::operator=(Buffer&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

Buffer::~Buffer()
{
    if (name_) glDeleteBuffers(1, &name_);
}

void Buffer::write(std::span<const std::byte> bytes)
{
    if (!name_) glGenBuffers(1, &name_);
    bytes_ = bytes.size();
    // A target no vertex array records, so that writing never changes one that is bound.
    glBindBuffer(GL_COPY_WRITE_BUFFER, name_);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                 GL_DYNAMIC_DRAW);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

} // namespace trivar::gpu
