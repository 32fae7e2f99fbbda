// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"

namespace trivar {

// The words of the command that changes a kind of shape: `verb`, `summary`, the `help` of its
// object, "id of a text", and the `title` of many changes, unless title_of_change() says it.
template <class Shape> struct SetWords;

// Gives an object another shape of the kind that it has.
template <class Shape> struct SetShape {
    static constexpr std::string_view verb = SetWords<Shape>::verb,
                                      summary = SetWords<Shape>::summary;
    Id object = 0;
    Shape shape = {};
    bool operator==(const SetShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, SetWords<Shape>::help, required.names_object());
        spread(c.shape, field);
    }
    // The command that changes nothing of the object; none: it has another kind of shape.
    static std::optional<SetShape> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<Shape>(&object.source);
        if (!own) return std::nullopt;
        return SetShape{id, *own};
    }
};
template <class Shape> Document applied(Document document, const SetShape<Shape>& command)
{
    if (!std::holds_alternative<Shape>(object(document, command.object).source))
        refuse_other_kind(document, command.object, SetWords<Shape>::help);
    if constexpr (requires { check(command.shape); }) check(command.shape);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.source = command.shape; });
}

template <class Shape> StepTitle title(const SetShape<Shape>& c, const StepDocuments& step)
{
    const Object* object = step.was(c.object);
    const auto* old = object ? std::get_if<Shape>(&object->source) : nullptr;
    const std::string name = name_in(step.before, c.object);
    if constexpr (requires { title_of_change(old, c.shape, name); })
        return title_of_change(old, c.shape, name);
    else
        return title_of_changes(old ? changes(*old, c.shape) : Changes{},
                                std::string(SetWords<Shape>::title), name);
}

} // namespace trivar
