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

Document applied(Document document, const SetText& command)
{
    if (!std::holds_alternative<TextShape>(object(document, command.object).source))
        throw Rejected(fmt::format("field \"object\": {} is not a text", command.object));
    check(command.shape);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.source = command.shape; });
}

StepTitle title(const SetText& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    const Object* object = step.was(c.object);
    const auto* old = object ? std::get_if<TextShape>(&object->source) : nullptr;
    if (!old) return {"Text of " + name, {}};
    if (old->text != c.shape.text) return {"Letters of " + name, size_words(c.shape)};
    if (old->font != c.shape.font) return {"Font of " + name, c.shape.font};
    return {"Shape of the letters of " + name, {}};
}

} // namespace trivar
