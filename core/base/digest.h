// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace trivar {

// A Digest is a running 128-bit digest (XXH3) of values in the order in which they are added. It
// tells contents apart; it is no defence against a person who wants two contents to have one
// digest.
class Digest {
public:
    Digest();
    ~Digest();
    Digest(const Digest&) = delete;
    Digest& operator=(const Digest&) = delete;

    void add_bytes(std::span<const std::byte> bytes);
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void add(std::span<const T> values) { add_bytes(std::as_bytes(values)); }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void add(const T& value) { add_bytes(std::as_bytes(std::span(&value, 1))); }
    void add_text(std::string_view text); // its length, then its bytes

    std::string hex() const; // 32 lower-case hexadecimal digits

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar
