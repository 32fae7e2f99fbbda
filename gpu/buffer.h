// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace trivar::gpu {

// A Buffer is a GL buffer object. Like all wrappers here it needs the context in which it was made
// to be current.
class Buffer {
public:
    Buffer() = default;
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    // Replaces the contents; the old storage is orphaned, so nothing waits for draws in progress.
    // Throws Rejected where the device has no room for large contents.
    void write(std::span<const std::byte> bytes);
    // Replaces a part of the contents, which must have been written or reserved before.
    void write_part(std::size_t at, std::span<const std::byte> bytes) const;
    // Makes room for `bytes` bytes, unless there is that much already; the contents are undefined.
    // Throws Rejected where the device has no room.
    void reserve(std::size_t bytes);
    // Reads the contents; waits until pending writes are done.
    void read(std::span<std::byte> into) const;
    unsigned name() const { return name_; }
    std::size_t bytes() const { return bytes_; }

private:
    unsigned name_ = 0;
    std::size_t bytes_ = 0;
};

} // namespace trivar::gpu
