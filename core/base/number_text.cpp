// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace trivar {
namespace {

constexpr int least_power = -9, most_power = 15; // of ten, of what is written without one

// The digits of a size, without trailing zeros, and the power of ten of the first; of count 0 the
// fewest that read back as the same bits.
struct Digits {
    std::string digits;
    int power;
};
Digits digits_of(double size, int count)
{
    std::array<char, 64> buffer{};
    char* const from = buffer.data();
    char* const to = from + buffer.size();
    constexpr auto form = std::chars_format::scientific;
    std::string text(from, count == 0 ? std::to_chars(from, to, size, form).ptr
                                      : std::to_chars(from, to, size, form, count - 1).ptr);
    const std::size_t e = text.find('e');
    const int power = std::stoi(text.substr(e + 1));
    text.erase(e);
    std::erase(text, '.');
    text.erase(std::max<std::size_t>(text.find_last_not_of('0') + 1, 1));
    return {text, power};
}

void insert_commas(std::string& digits)
{
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
}

std::string raised(int power)
{
    constexpr std::string_view small[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(power)) text += c == '-' ? "⁻" : small[c - '0'];
    return text;
}

} // namespace

std::string number_text(double value, NumberForm form)
{
    if (std::isnan(value)) return "not a number";
    const std::string sign = value < 0 ? "-" : "";
    if (std::isinf(value)) return sign + "infinite";
    if (value == 0) return "0";
    const double size = std::abs(value);
    const Digits exact = digits_of(size, 0);
    const int digits =
        form.digits == 0 ? static_cast<int>(exact.digits.size()) : std::clamp(form.digits, 1, 17);
    Digits number = digits_of(size, digits);
    if (form.power || number.power < least_power || number.power > most_power) {
        if (number.digits.size() > 1) number.digits.insert(1, 1, '.');
        return sign + number.digits + "·10" + raised(number.power);
    }
    if (exact.power >= digits) number = digits_of(size, exact.power + 1);
    const auto before = static_cast<std::size_t>(std::max(number.power, 0)) + 1;
    if (number.power < 0) number.digits.insert(0, static_cast<std::size_t>(-number.power), '0');
    const int room = std::max(0, std::min(digits, 3) - 1 - std::max(number.power, 0));
    const auto behind = static_cast<std::size_t>(std::min(form.decimals, room));
    const std::size_t least = before + behind;
    if (number.digits.size() < least) number.digits.resize(least, '0');
    std::string whole = number.digits.substr(0, before);
    const std::string rest = number.digits.substr(before);
    if (form.commas) insert_commas(whole);
    return sign + whole + (rest.empty() ? "" : "." + rest);
}

std::string with_commas(std::uint64_t count)
{
    std::string digits = std::to_string(count);
    insert_commas(digits);
    return digits;
}

std::string percent_text(double share)
{
    constexpr double least = 1e-4;
    if (share > 0 && share < least) return "under 0.01 %";
    return number_text(100 * share, {.digits = 2}) + " %";
}

} // namespace trivar
