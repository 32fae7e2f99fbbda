// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace trivar::gpu {

// A GL buffer object. Needs the context it was made in to be current, as all wrappers here do.
class Buffer {
public:
    Buffer() = default;
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    // Replaces the contents; the old storage is orphaned, so nothing waits for draws under way.
    // Throws Rejected where there is no room for much.
    void write(std::span<const std::byte> bytes);
    // So many bytes of anything, kept where there are that many already. Throws Rejected where the
    // device has no room.
    void reserve(std::size_t bytes);
    // Waits until what is written there has been written.
    void read(std::span<std::byte> into) const;
    unsigned name() const { return name_; }
    std::size_t bytes() const { return bytes_; }

private:
    unsigned name_ = 0;
    std::size_t bytes_ = 0;
};

} // namespace trivar::gpu
