// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/every_command.h"
#include "core/commands/json_text.h"

#include <fmt/format.h>

namespace trivar {

std::string json_text(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text)
        if (c == '"' || c == '\\')
            result += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20)
            result += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            result += c;
    return result + '"';
}

std::string json_text(double value)
{
    // A reader takes -0 for an integer, which has no sign.
    return value == 0 && std::signbit(value) ? "-0.0" : shortest(value);
}

std::string json_text(float value)
{
    return value == 0 && std::signbit(value) ? "-0.0" : shortest(value);
}

void append_field(std::string& text, std::string_view& separator, std::string_view name,
                  const std::string& value)
{
    text.append(separator).append(json_text(name)).append(":").append(value);
    separator = ",";
}

std::string to_json_line(const Command& command)
{
    return visit(
        []<class C>(const C& c) {
            return "{\"do\":" + json_text(C::verb) + fields_json(c, ",") + "}";
        },
        command);
}

} // namespace trivar
