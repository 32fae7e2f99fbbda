// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace trivar {

std::string in_words(std::string_view name)
{
    std::string label(name.substr(0, name.ends_with("_deg") ? name.size() - 4 : name.size()));
    std::ranges::replace(label, '_', ' ');
    if (!label.empty())
        label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

std::string label_of(std::string_view name, const Rule& rule)
{
    return rule.label.empty() ? in_words(name) : std::string(rule.label);
}

std::string unit_text(Unit unit)
{
    switch (unit) {
    case Unit::metres: return "m";
    case Unit::degrees:
    case Unit::radians: return "deg";
    case Unit::seconds: return "s";
    case Unit::metres_per_second: return "m/s";
    case Unit::frames_per_second: return "fps";
    case Unit::stops: return "stops";
    case Unit::share: return "%";
    case Unit::times: return "x";
    case Unit::turns: return "turns";
    case Unit::sides: return "sides";
    case Unit::pixels: return "px";
    case Unit::at_frame:
    case Unit::none: break;
    }
    return {};
}

double shown_factor(Unit unit)
{
    constexpr double degrees = 57.29577951308232;
    if (unit == Unit::share) return 100;
    return unit == Unit::radians ? degrees : 1;
}

std::string axis_of(const Rule& rule, int component)
{
    std::string_view names = rule.axes;
    for (; component > 0 && names.find('|') != names.npos; --component)
        names.remove_prefix(names.find('|') + 1);
    return std::string(names.substr(0, names.find('|')));
}

std::string in_metres(double value)
{
    return with_unit(value, Unit::metres);
}

std::string in_degrees(double value)
{
    return with_unit(value, Unit::degrees);
}

std::string with_unit(double value, Unit unit)
{
    const std::string number = number_text(value * shown_factor(unit));
    if (unit == Unit::at_frame) return "at frame " + number_text(value, {.commas = false});
    if (unit == Unit::degrees || unit == Unit::radians) return number + "°";
    std::string of = unit_text(unit);
    const bool counted = unit == Unit::stops || unit == Unit::turns || unit == Unit::sides;
    if (counted && std::abs(value) == 1) of.pop_back(); // "1 stop"
    return of.empty() ? number : number + " " + of;
}

} // namespace trivar
