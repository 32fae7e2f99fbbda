// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/byte_damage.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace trivar::testing {
namespace {

const std::vector<std::string> extreme_words{
    "1e999", "-1",         "nan",         "inf",    "4294967295", "-0",
    "0",     "2147483648", "-2147483649", "1e-320", "3e38",       "-3e38",
    "1e308", "",           "1e9",         "0x7",    "1,5",        "18446744073709551616"};

// Extreme values of four bytes: -1, the largest and the least, NaN, infinity, -0 and huge numbers.
constexpr std::array<std::uint32_t, 10> extreme_bits{
    0xffffffffu, 0x7fffffffu, 0x80000000u, 0x7fc00000u, 0x7f800000u,
    0x7f7fffffu, 0xff7fffffu, 0x00000001u, 0x00010000u, 0u};

struct Stretch {
    std::size_t begin, length;
};

// Most are short; the bytes are not empty.
Stretch stretch(const std::string& bytes, Dice& dice)
{
    const std::size_t begin = dice.below(bytes.size());
    const std::size_t most = dice.below(4) == 0 ? bytes.size() - begin : 64;
    return {begin, std::min(1 + dice.below(most), bytes.size() - begin)};
}

void change_bytes(std::string& bytes, Dice& dice)
{
    for (std::size_t left = 1 + dice.below(8); left > 0; --left) {
        char& byte = bytes[dice.below(bytes.size())];
        if (dice.below(2) == 0)
            byte = static_cast<char>(byte ^ (1 << dice.below(8)));
        else
            byte = static_cast<char>(dice.below(256));
    }
}

void blot(std::string& bytes, Dice& dice)
{
    const auto [begin, length] = stretch(bytes, dice);
    bytes.replace(begin, length, length, dice.below(2) == 0 ? '\0' : '\xff');
}

void double_stretch(std::string& bytes, Dice& dice)
{
    const auto [begin, length] = stretch(bytes, dice);
    bytes.insert(dice.below(2) == 0 ? begin : dice.below(bytes.size()),
                 bytes.substr(begin, length));
}

void leave_out(std::string& bytes, Dice& dice)
{
    const auto [begin, length] = stretch(bytes, dice);
    bytes.erase(begin, length);
}

// In place of the next word after a random place.
void put_word(std::string& bytes, Dice& dice)
{
    constexpr const char* digits = "0123456789.-";
    const std::size_t begin = bytes.find_first_of(digits, dice.below(bytes.size()));
    if (begin == bytes.npos) return;
    const std::size_t end = std::min(bytes.find_first_not_of(digits, begin), bytes.size());
    bytes.replace(begin, end - begin, dice.one_of(extreme_words));
}

void put_bits(std::string& bytes, Dice& dice)
{
    if (bytes.size() < 4) return;
    std::size_t at = dice.below(bytes.size() - 3);
    if (dice.below(2) == 0) at = at / 4 * 4;
    std::memcpy(bytes.data() + at, &extreme_bits[dice.below(extreme_bits.size())], 4);
}

void join(std::string& bytes, const std::vector<std::string>& others, Dice& dice)
{
    const std::string& other = dice.one_of(others);
    switch (dice.below(3)) {
    case 0: bytes += other; break;
    case 1: bytes.insert(dice.below(bytes.size()), other); break;
    default: bytes = bytes.substr(0, dice.below(bytes.size())) + other.substr(other.size() / 2);
    }
}

} // namespace

std::string with_bytes_damaged(std::string bytes, const std::vector<std::string>& others,
                               Dice& dice)
{
    for (std::size_t left = dice.few(); left > 0 && !bytes.empty(); --left)
        switch (dice.below(10)) {
        case 0:
        case 1: change_bytes(bytes, dice); break;
        case 2: blot(bytes, dice); break;
        case 3: bytes.resize(dice.below(bytes.size())); break;
        case 4: double_stretch(bytes, dice); break;
        case 5: leave_out(bytes, dice); break;
        case 6:
        case 7: put_word(bytes, dice); break;
        case 8: put_bits(bytes, dice); break;
        default: join(bytes, others, dice);
        }
    return bytes;
}

} // namespace trivar::testing
