// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/key_words.h"

#include "editor/field_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace trivar {
namespace {

std::vector<std::string> parts_of(const std::string& parameter)
{
    std::vector<std::string> parts{""};
    for (const char c : parameter)
        if (c == '.')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

bool is_count(const std::string& part)
{
    constexpr std::size_t most = 6; // digits; names of views may have more
    return !part.empty() && part.size() <= most &&
           std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Of the last part of a name, where it is the component of something.
std::string component(const std::string& of, const std::string& part)
{
    const auto at = std::string_view("xyzw").find(part);
    if (part.size() != 1 || at == std::string_view::npos) return {};
    if (of == "base_color")
        return std::array<const char*, 4>{"red", "green", "blue", "opacity"}.at(at);
    return std::string(1, static_cast<char>(std::toupper(part[0])));
}

std::string unit_of(const std::string& parameter, const std::string& field)
{
    constexpr std::array lengths{"translation", "radius",    "size",      "height",
                                 "depth",       "bevel",     "eye",       "target",
                                 "width",       "clearance", "tolerance", "height_world"};
    if (field.ends_with("_deg")) return "deg";
    if (parameter == "playing.offset") return "s";
    return std::ranges::find(lengths, field) != lengths.end() ? "m" : "";
}

} // namespace

NumberWords words_of_number(const std::string& parameter)
{
    constexpr double degrees = 57.29577951308232;
    const std::vector<std::string> parts = parts_of(parameter);
    NumberWords out;
    const bool grouped = parts.size() > 1; // by what its panel says already
    std::size_t last = parts.size() - 1;
    const std::string axis = last > 0 ? component(parts[last - 1], parts[last]) : std::string();
    if (!axis.empty()) --last;
    const std::string& field = parts[last];
    const bool named = grouped && (parts[0] == "camera" || parts[0] == "shaping");
    for (std::size_t i = grouped && !named ? 1 : 0; i <= last; ++i) {
        std::string word = is_count(parts[i])            ? std::to_string(std::stol(parts[i]) + 1)
                           : parts[i] == "base_color"    ? "Colour"
                           : parts[i] == "sun_azimuth"   ? "Sun round"
                           : parts[i] == "sun_elevation" ? "Sun height"
                           : parts[i] == "shaping"       ? "Step"
                           : parts[i] == "fov_y"         ? "Field of view"
                           : parts[i] == "contact_level" ? "Sunk"
                                                         : label_of_field(parts[i]);
        if (i > (grouped && !named ? 1u : 0u) && !word.empty())
            word[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
        if (word == "camera" || word == "Camera") continue;
        out.label += (out.label.empty() ? "" : " ") + word;
    }
    if (!axis.empty()) out.label += " " + axis;
    if (!out.label.empty())
        out.label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out.label[0])));
    out.unit = unit_of(parameter, field);
    if (field == "sun_azimuth" || field == "sun_elevation" || field == "fov_y") {
        out.unit = "deg";
        out.factor = degrees;
    }
    return out;
}

} // namespace trivar
