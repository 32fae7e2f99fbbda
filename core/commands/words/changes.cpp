// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/changes.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace trivar {
namespace {

std::string with_small_letter(std::string text)
{
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

} // namespace

std::string color_text(const glm::vec3& linear)
{
    const auto byte = [](float c) {
        const double s = c <= 0.0031308f ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
        return static_cast<int>(std::lround(std::min(std::max(s, 0.0), 1.0) * 255));
    };
    return fmt::format("#{:02X}{:02X}{:02X}", byte(linear.x), byte(linear.y), byte(linear.z));
}

StepTitle title_of_changes(const Changes& changes, const std::string& whole,
                           const std::string& object)
{
    const std::string of = object.empty() ? "" : " of " + object;
    if (changes.empty()) return {whole + of, "as before"};
    if (changes.size() == 1) return {changes[0].name + of, changes[0].value};
    if (changes.size() == 2)
        return {changes[0].name + " and " + with_small_letter(changes[1].name) + of, {}};
    return {whole + of, fmt::format("{} values", changes.size())};
}

} // namespace trivar
