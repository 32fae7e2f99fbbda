// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/text.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

// Quotes the part of a text for which a row has room.
std::string size_words(const TextShape& s)
{
    constexpr std::size_t most = 24; // bytes
    std::size_t end = std::min({s.text.find('\n'), s.text.size(), most});
    while (end < s.text.size() && end > 0 && (s.text[end] & '\xC0') == '\x80') --end;
    return "“" + s.text.substr(0, end) + (end < s.text.size() ? "…" : "") + "”";
}

StepTitle title_of_change(const TextShape* before, const TextShape& now, const std::string& name)
{
    if (!before) return {"Text of " + name, {}};
    if (before->text != now.text) return {"Letters of " + name, size_words(now)};
    if (before->font != now.font) return {"Font of " + name, now.font};
    return {"Shape of the letters of " + name, {}};
}

} // namespace trivar
