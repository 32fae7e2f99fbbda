// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/field_words.h"

#include <algorithm>
#include <cctype>

namespace trivar {

std::string label_of_field(std::string_view name)
{
    if (name == "translation") return "Position";
    std::string label(name.substr(0, name.ends_with("_deg") ? name.size() - 4 : name.size()));
    std::ranges::replace(label, '_', ' ');
    if (!label.empty())
        label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

std::string unit_of_field(std::string_view name, std::string_view help)
{
    if (name.ends_with("_deg")) return "deg";
    if (help.starts_with("metres a second")) return "m/s";
    if (help.starts_with("seconds")) return "s";
    if (help.find("radians") != help.npos) return "rad";
    return help.find("metres") != help.npos ? "m" : "";
}

} // namespace trivar
