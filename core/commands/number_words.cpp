// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/number_words.h"

#include "core/commands/changes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
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
    if (of == "grid" || of == "orders") return std::array<const char*, 3>{"U", "V", "W"}.at(at);
    return std::string(1, static_cast<char>(std::toupper(part[0])));
}

// What the panels call a field, where that is not its name.
std::string label_of_part(const std::string& field)
{
    constexpr std::array<std::array<const char*, 2>, 24> called{{
        {"base_color", "Colour"},
        {"solid", "Filling"},
        {"sun_azimuth", "Sun round"},
        {"sun_elevation", "Sun height"},
        {"ambient_occlusion", "Corners"},
        {"wire", "Edges"},
        {"color_by", "Colour by"},
        {"eye", "From"},
        {"target", "To"},
        {"fov_y", "Angle"},
        {"grid", "Density"},
        {"orders", "Order"},
        {"springs", "Gaps bridged"},
        {"neighborhood", "Reach"},
        {"free_ends", "Free ends"},
        {"sharp", "Sharp edges"},
        {"lift_tolerance", "Sinking"},
        {"skip_back_faces", "Back faces pass"},
        {"contact_level", "Sunk"},
        {"along", "Axis along"},
        {"reverse", "Turned round"},
        {"letter_spacing", "Letter gap"},
        {"line_spacing", "Line gap"},
        {"max_edge", "Longest edge"},
    }};
    for (const auto& [name, label] : called)
        if (field == name) return label;
    return field == "shaping" ? "Step" : label_of_field(field);
}

std::string unit_of(const std::string& parameter, const std::string& field)
{
    constexpr std::array lengths{"translation", "radius",       "size",   "height", "depth",
                                 "bevel",       "eye",          "target", "width",  "clearance",
                                 "tolerance",   "height_world", "gap",    "tube",   "level"};
    if (field.ends_with("_deg")) return "deg";
    if (parameter == "playing.offset") return "s";
    if (parameter == "shape.tolerance") return ""; // part of the size
    return std::ranges::find(lengths, field) != lengths.end() ? "m" : "";
}

} // namespace

std::string label_of_field(std::string_view name)
{
    if (name == "translation") return "Position";
    std::string label(name.substr(0, name.ends_with("_deg") ? name.size() - 4 : name.size()));
    std::ranges::replace(label, '_', ' ');
    if (!label.empty())
        label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

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
        std::string word =
            is_count(parts[i]) ? std::to_string(std::stol(parts[i]) + 1) : label_of_part(parts[i]);
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

std::string words_of_value(const Parameter& parameter, double value)
{
    using Kind = Parameter::Kind;
    if (parameter.kind == Kind::on_off) return value >= 0.5 ? "on" : "off";
    if (parameter.kind == Kind::choice) {
        const double most = static_cast<double>(parameter.choices.size()) - 1;
        const auto chosen = static_cast<std::size_t>(std::clamp(std::round(value), 0.0, most));
        return label_of_field(parameter.choices[chosen]);
    }
    const NumberWords words = words_of_number(parameter.name);
    const double shown = value * words.factor;
    if (words.unit == "deg") return in_degrees(shown);
    return brief_number(shown) + (words.unit.empty() ? "" : " " + words.unit);
}

} // namespace trivar
