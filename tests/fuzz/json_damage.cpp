// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/json_damage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace trivar::testing {
namespace {

using Json = nlohmann::ordered_json;

// Numbers as they are to stand in the text: JSON libraries would not hold all of them.
const std::vector<std::string> extreme_numbers{
    "-1",          "0",          "1",          "2",           "0.5",
    "-0",          "-0.0",       "0.001",      "1e-320",      "1e39",
    "1e308",       "-1e308",     "1e999",      "255",         "256",
    "65535",       "65536",      "1000000",    "2147483647",  "2147483648",
    "-2147483649", "4294967295", "4294967296", "1e9",         "9007199254740992",
    "3.4e38",      "NaN",        "-7",         "1073741824",  "9223372036854775807",
    "1e10",        "-1e-9",      "100",        "-2147483648", "18446744073709551616"};

std::vector<std::string> extreme_values()
{
    std::vector<std::string> out{"null",
                                 "true",
                                 "false",
                                 "[]",
                                 "{}",
                                 "[[]]",
                                 "[-1]",
                                 "[0,0,0]",
                                 "[1e308,1e308,1e308,1e308]",
                                 "[null]",
                                 R"({"a":1})",
                                 R"("")",
                                 R"("x")",
                                 R"("\u0000")",
                                 R"("\n\u001b[2J")",
                                 R"("\u009b")",
                                 R"("\ud800")",
                                 R"("../../etc/passwd")",
                                 R"("data:,")",
                                 R"("data:application/octet-stream;base64,AAAA")",
                                 R"("a\\b/.\\c.png")",
                                 "\"\xff\xfe\""};
    out.push_back('"' + std::string(3000, 'A') + '"');
    for (const std::size_t deep : {std::size_t{20}, std::size_t{47}, std::size_t{5000}})
        out.push_back(std::string(deep, '[') + std::string(deep, ']'));
    return out;
}

// A number is mostly replaced by one: what is of another type is soon refused.
std::string extreme_for(const Json& value, Dice& dice)
{
    const bool number = value.is_number() && dice.below(4) != 0;
    return dice.one_of(number ? extreme_numbers : extreme_values());
}

// One that is not far from it, or an index that may be there: what it says may well be taken.
Json other_number(const Json& number, Dice& dice)
{
    if (dice.below(2) == 0) return dice.below(20);
    const auto was = number.get<double>();
    const std::vector<double> near{2 * was, -was, was + 1, was - 1, was / 2, 10 * was, was / 1000};
    const double now = dice.one_of(near);
    if (number.is_number_integer() && std::abs(now) < 1e9) return static_cast<int>(now);
    return now;
}

// A value inside a list or an object.
struct Slot {
    Json* outer;
    std::size_t at;
    Json& value() const { return *std::next(outer->begin(), static_cast<std::ptrdiff_t>(at)); }
};

// Found by going inward from the root, so that a field is as likely as a list of a thousand
// numbers.
Slot some_slot(Json& root, Dice& dice)
{
    Slot slot{&root, dice.below(root.size())};
    while (slot.value().is_structured() && !slot.value().empty() && dice.below(4) != 0) {
        Json& inner = slot.value();
        slot = {&inner, dice.below(inner.size())};
    }
    return slot;
}

bool holds(const Json& outer, const Json& inner)
{
    if (&outer == &inner) return true;
    if (!outer.is_structured()) return false;
    return std::ranges::any_of(outer, [&](const Json& part) { return holds(part, inner); });
}

constexpr const char* mark = "@replaced@";

std::string with_marks_replaced(std::string text, const std::vector<std::string>& raw)
{
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const std::string marked = '"' + (mark + std::to_string(i)) + '"';
        for (std::size_t at = 0; (at = text.find(marked, at)) != text.npos; at += raw[i].size())
            text.replace(at, marked.size(), raw[i]);
    }
    return text;
}

// Puts a mark where text is to stand that no JSON library writes, and that text into `raw`.
void damage_value(Json& root, std::vector<std::string>& raw, Dice& dice)
{
    const Slot slot = some_slot(root, dice), other = some_slot(root, dice);
    Json& value = slot.value();
    if (value.is_number() && dice.below(2) == 0) {
        value = other_number(value, dice);
        return;
    }
    switch (dice.below(8)) {
    case 0: value = Json(other.value()); break;
    case 1:
        if (!holds(value, other.value()) && !holds(other.value(), value))
            std::swap(value, other.value());
        break;
    case 2:
    case 3:
        slot.outer->erase(std::next(slot.outer->begin(), static_cast<std::ptrdiff_t>(slot.at)));
        break;
    default: raw.push_back(extreme_for(value, dice)); value = mark + std::to_string(raw.size() - 1);
    }
}

} // namespace

std::string with_values_replaced(const std::string& json, Dice& dice)
{
    Json root = Json::parse(json, nullptr, false);
    std::vector<std::string> raw;
    for (std::size_t left = dice.below(3) == 0 ? 2 : 1; left > 0; --left)
        if (root.is_structured() && !root.empty()) damage_value(root, raw, dice);
    return with_marks_replaced(root.dump(-1, ' ', false, Json::error_handler_t::replace), raw);
}

} // namespace trivar::testing
