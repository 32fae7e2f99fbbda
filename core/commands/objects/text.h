// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/text_fields.h"

namespace trivar {

// The first letters, in quotes: as many as a row has room for.
std::string size_words(const TextShape& shape);

using AddText = AddShape<TextShape>;

struct SetText {
    static constexpr std::string_view verb = "set_text", summary = "Change a text in place.";
    Id object = 0;
    TextShape shape;
    bool operator==(const SetText&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a text", required.names_object());
        spread(c.shape, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<SetText> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<TextShape>(&object.source);
        if (!own) return std::nullopt;
        return SetText{id, *own};
    }
};
Document applied(Document document, const SetText& command);
StepTitle title(const SetText& c, const StepDocuments& step);

} // namespace trivar
