// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/vertex_array.h"

#include <epoxy/gl.h>
#include <utility>

namespace trivar::gpu {

VertexArray::VertexArray()
{
    glGenVertexArrays(1, &name_);
}

VertexArray::VertexArray(VertexArray&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept
{
    std::swap(name_, other.name_);
    return *this;
}

VertexArray::~VertexArray()
{
    if (name_) glDeleteVertexArrays(1, &name_);
}

void VertexArray::attribute(unsigned location, const Buffer& buffer, int components, int stride,
                            std::size_t offset, unsigned divisor) const
{
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void VertexArray::integers(unsigned location, const Buffer& buffer, int components, int stride,
                           std::size_t offset, unsigned divisor) const
{
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glEnableVertexAttribArray(location);
    glVertexAttribIPointer(location, components, GL_UNSIGNED_INT, stride,
                           reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void VertexArray::indices(const Buffer& buffer)
{
    bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.name());
    glBindVertexArray(0);
}

void VertexArray::bind() const
{
    glBindVertexArray(name_);
}

} // namespace trivar::gpu
