// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/as_it_is.h"

#include "core/commands/every_command.h"
#include "core/commands/objects/view.h"
#include "editor/commands/new_material.h"

namespace trivar {

std::optional<Command> as_it_is(const Command& kind, Id id, const Document& document)
{
    if (kind.is<SetRender>()) return SetRender{*document.render};
    if (kind.is<SetTime>()) return SetTime{document.time};
    const auto found = document.objects.find(id);
    if (found == document.objects.end()) return std::nullopt;
    const Object& object = *found->second;
    return visit(
        [&]<class C>(const C&) -> std::optional<Command> {
            if constexpr (requires { C::as_it_is(object, id); }) {
                if (std::optional<C> same = C::as_it_is(object, id))
                    return Command(std::move(*same));
            } else if constexpr (requires { C::sets; }) {
                const auto& own = object.*C::sets;
                if constexpr (!is_optional<std::remove_cvref_t<decltype(own)>>)
                    return C{{id}, own};
                else if (own)
                    return C{{id}, *own};
            }
            return std::nullopt;
        },
        kind);
}

Command about(Command command, const std::vector<Id>& ids)
{
    change(command, [&](auto& c) {
        if constexpr (requires { c.objects; }) c.objects = ids;
        if constexpr (requires { c.object; }) c.object = ids.empty() ? 0 : ids.back();
        if constexpr (requires { c.material; }) c.material = new_material;
    });
    return command;
}

bool is_about_objects(const Command& command)
{
    return visit(
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
