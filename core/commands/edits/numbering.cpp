// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/edits/numbering.h"

#include <fmt/format.h>

namespace trivar {

Numbering::Numbering(const Document& document)
{
    for (const auto& [id, ref] : document.objects) taken_.insert(ref->name);
}

std::string Numbering::next(const std::string& name)
{
    std::string stem = name;
    const std::size_t space = name.rfind(' ');
    if (space != std::string::npos && space > 0 && space + 1 < name.size() &&
        name.find_first_not_of("0123456789", space + 1) == std::string::npos)
        stem.resize(space);
    int& number = numbers_.try_emplace(stem, 2).first->second;
    std::string candidate;
    do candidate = fmt::format("{} {}", stem, number++);
    while (!taken_.insert(candidate).second);
    return candidate;
}

std::string Numbering::unique(const std::string& name)
{
    return taken_.insert(name).second ? name : next(name);
}

} // namespace trivar
