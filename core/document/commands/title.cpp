// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/command.h"

#include <cctype>

namespace trivar {
namespace {

std::string name_of(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? "object " + std::to_string(id) : found->second->name;
}

} // namespace

std::string_view verb(const Command& command)
{
    return std::visit([]<class C>(const C&) { return C::verb; }, command);
}

std::string title(const Command& command, const Document& before)
{
    std::string words(verb(command));
    for (char& c : words)
        if (c == '_') c = ' ';
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return std::visit(
        [&](const auto& c) {
            if constexpr (requires { c.object; })
                return words + " " + name_of(before, c.object);
            else if constexpr (requires { c.objects; })
                return words + " " +
                       (c.objects.size() == 1 ? name_of(before, c.objects.front())
                                              : std::to_string(c.objects.size()) + " objects");
            else if constexpr (requires { c.file; })
                return words + " " + (c.name.empty() ? c.file.path : c.name);
            else if constexpr (requires {
                                   c.camera;
                                   c.name;
                               })
                return words + " " + c.name;
            else
                return words;
        },
        command);
}

} // namespace trivar
