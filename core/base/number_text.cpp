// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace trivar {
namespace {

constexpr int least_power = -9, most_power = 14; // of ten, of what is written without one

// The digits of a size, without trailing zeros, and the power of ten of the first.
struct Digits {
    std::string digits;
    int power;
};
Digits digits_of(double size, int count)
{
    std::string text = fmt::format("{:.{}e}", size, std::clamp(count, 1, 17) - 1);
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
    if (std::isnan(value)) return "no number";
    const std::string sign = value < 0 ? "-" : "";
    if (std::isinf(value)) return sign + "infinite";
    if (value == 0) return "0";
    const double size = std::abs(value);
    const int whole_digits = digits_of(size, 17).power + 1;
    Digits number = digits_of(size, form.digits);
    if (number.power < least_power || number.power > most_power) {
        if (number.digits.size() > 1) number.digits.insert(1, 1, '.');
        return sign + number.digits + "·10" + raised(number.power);
    }
    if (whole_digits > form.digits) number = digits_of(size, whole_digits);
    const auto before = static_cast<std::size_t>(std::max(number.power, 0)) + 1;
    if (number.power < 0) number.digits.insert(0, static_cast<std::size_t>(-number.power), '0');
    const int room = std::max(0, form.digits - 1 - std::max(number.power, 0));
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
    return number_text(100 * share, {.digits = 2}) + " %";
}

} // namespace trivar
