// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/number_rows.h"

#include "core/commands/words/number_words.h"
#include "editor/words/volume_words.h"

#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace trivar {
namespace {

bool only_by_keys(const Object& object, const Parameter& number)
{
    const std::string& name = number.name;
    if (name.starts_with("shape.")) return !kind_of(object).has_rows;
    const bool step = name.find(".press.") != name.npos || name.find(".shift.") != name.npos ||
                      name.find(".warp.") != name.npos;
    return name.starts_with("shaping.") && step && name.find(".samples.") == name.npos &&
           name.find(".points.") == name.npos;
}

// Returns the prefix of all numbers of one step: "shaping.2.shift" for "shaping.2.shift.by.x";
// empty if the number belongs to no step.
std::string step_of(const std::string& parameter)
{
    std::size_t end = parameter.starts_with("shaping.") ? 0 : parameter.npos;
    for (int part = 0; part < 3 && end != parameter.npos; ++part)
        end = parameter.find('.', end + 1);
    return end == parameter.npos ? "" : parameter.substr(0, end);
}

std::string caption_of(const Object& object, const std::string& step)
{
    const std::size_t number = std::stoul(step.substr(step.find('.') + 1));
    const bool box = kind_of(object).has_cage;
    return fmt::format("Step {}: {}", number + 1, words_of(*object.shaping[number], box));
}

// Returns the part of a label that differs among the numbers of one step: "Move X" of "Step 1 shift
// move X".
std::string label_in(const std::string& step, const std::string& label)
{
    std::string own = step.empty() ? label : label.substr(words_of_number(step).label.size() + 1);
    own[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(own[0])));
    return own;
}

} // namespace

std::vector<NumberRow> number_rows(const Object& object, std::size_t most)
{
    std::vector<NumberRow> rows;
    std::string step;
    for (Parameter& number : parameters(object)) {
        if (rows.size() == most) break;
        if (!only_by_keys(object, number)) continue;
        const std::string before = std::exchange(step, step_of(number.name));
        const bool begins = !step.empty() && step != before;
        std::string label = label_in(step, words_of_number(number.name).label);
        rows.push_back(
            {begins ? caption_of(object, step) : "", std::move(label), std::move(number)});
    }
    return rows;
}

} // namespace trivar
