// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/objects/set_shape.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/text_fields.h"

namespace trivar {

// The first letters, in quotes: as many as a row has room for.
std::string size_words(const TextShape& shape);

using AddText = AddShape<TextShape>;

template <> struct SetWords<TextShape> {
    static constexpr std::string_view verb = "set_text", summary = "Change a text in place.",
                                      help = "id of a text";
};
using SetText = SetShape<TextShape>;
StepTitle title_of_change(const TextShape* before, const TextShape& now, const std::string& name);

} // namespace trivar
