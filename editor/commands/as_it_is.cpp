// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/as_it_is.h"

#include "editor/commands/new_material.h"

namespace trivar {

std::optional<Command> as_it_is(const Command& kind, Id id, const Document& document)
{
    if (std::holds_alternative<SetRender>(kind)) return SetRender{*document.render};
    if (std::holds_alternative<SetTime>(kind)) return SetTime{document.time};
    const auto found = document.objects.find(id);
    if (found == document.objects.end()) return std::nullopt;
    const Object& object = *found->second;
    if (std::holds_alternative<SetTransform>(kind)) return SetTransform{id, object.transform};
    if (std::holds_alternative<SetTravel>(kind)) return SetTravel{{id}, object.travel};
    if (std::holds_alternative<PlayClip>(kind)) return PlayClip{{id}, object.playing};
    if (std::holds_alternative<Refine>(kind))
        return Refine{{id}, object.refining.value_or(Refining{})};
    if (std::holds_alternative<SetText>(kind))
        if (const auto* text = std::get_if<TextShape>(&object.source)) return SetText{id, *text};
    if (std::holds_alternative<EditImport>(kind))
        if (const auto* file = std::get_if<ImportedFile>(&object.source))
            return EditImport{id, *file};
    if (std::holds_alternative<SetMaterial>(kind) && object.surfacing)
        return SetMaterial{{id}, *object.surfacing};
    if (std::holds_alternative<EditPlacement>(kind) && object.placement)
        return EditPlacement{id, object.placement->parameters, {}, {}};
    return std::nullopt;
}

Command about(Command command, const std::vector<Id>& ids)
{
    std::visit(
        [&](auto& c) {
            if constexpr (requires { c.objects; }) c.objects = ids;
            if constexpr (requires { c.object; }) c.object = ids.empty() ? 0 : ids.back();
            if constexpr (requires { c.material; }) c.material = new_material;
        },
        command);
    return command;
}

bool is_about_objects(const Command& command)
{
    return std::visit(
        []<class C>(const C&) {
            return requires(const C& c)
            {
                c.object;
            }
            || requires(const C& c)
            {
                c.objects;
            };
        },
        command);
}

} // namespace trivar
