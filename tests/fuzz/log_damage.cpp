// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/log_damage.h"

#include "core/base/text.h"
#include "tests/fuzz/byte_damage.h"
#include "tests/fuzz/json_damage.h"

#include <utility>

namespace trivar::testing {
namespace {

using Lines = std::vector<std::string>;

void damage_line(Lines& lines, Dice& dice)
{
    const std::size_t at = dice.below(lines.size());
    const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
    switch (dice.below(12)) {
    case 0: lines.erase(place); break;
    case 1: lines.insert(place, std::string(*place)); break;
    case 2: std::swap(lines[at], lines[dice.below(lines.size())]); break;
    case 3: lines.insert(place, R"({"undo":true})"); break;
    case 4: lines.insert(place, R"({"redo":true})"); break;
    case 5: *place = with_bytes_damaged(*place, {lines[dice.below(lines.size())]}, dice); break;
    case 6: lines.insert(place, with_values_replaced(*place, dice)); break;
    default: *place = with_values_replaced(*place, dice);
    }
}

} // namespace

std::string with_lines_damaged(const std::string& log, Dice& dice)
{
    Lines lines;
    for (const std::string_view line : trimmed_lines(log)) lines.emplace_back(line);
    for (std::size_t left = dice.few(); left > 0 && !lines.empty(); --left)
        damage_line(lines, dice);
    std::string out;
    for (const std::string& line : lines) out += line + '\n';
    if (dice.below(16) == 0 && !out.empty()) out.resize(dice.below(out.size()));
    return out;
}

} // namespace trivar::testing
