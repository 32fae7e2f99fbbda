// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/buffer.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <utility>

namespace trivar::gpu {
namespace {

// To ask whether there was room may wait for the driver, which little is not worth.
constexpr std::size_t much = 1 << 16;

void fill(GLuint name, const void* data, std::size_t bytes, GLenum usage)
{
    while (bytes >= much && glGetError() != GL_NO_ERROR) // what was before is not ours
        ;
    // A target no vertex array records, so that writing never changes one that is bound.
    glBindBuffer(GL_COPY_WRITE_BUFFER, name);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), data, usage);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    if (bytes >= much && glGetError() != GL_NO_ERROR)
        throw Rejected(
            fmt::format("The graphics card has no room for {:.1f} MB more.", 1e-6 * bytes));
}

} // namespace

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
    fill(name_, bytes.data(), bytes.size(), GL_DYNAMIC_DRAW);
    bytes_ = bytes.size();
}

void Buffer::write_part(std::size_t at, std::span<const std::byte> bytes) const
{
    ensure(at + bytes.size() <= bytes_, "a buffer is written beyond its end");
    glBindBuffer(GL_COPY_WRITE_BUFFER, name_);
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(at),
                    static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void Buffer::reserve(std::size_t bytes)
{
    if (name_ && bytes_ == bytes) return;
    if (!name_) glGenBuffers(1, &name_);
    bytes_ = 0;
    fill(name_, nullptr, bytes, GL_DYNAMIC_COPY);
    bytes_ = bytes;
}

void Buffer::read(std::span<std::byte> into) const
{
    if (into.empty()) return;
    ensure(into.size() <= bytes_, "a buffer is read beyond its end");
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, name_);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(into.size()), into.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

} // namespace trivar::gpu
