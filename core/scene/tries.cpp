// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tries.h"

#include "core/commands/every_command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/commands/volumes/warp.h"

namespace trivar {
namespace {

template <class T> inline constexpr bool adds_shape = false;
template <class Shape> inline constexpr bool adds_shape<AddShape<Shape>> = true;

} // namespace

bool differ_in_numbers_only(const Command& a, const Command& b)
{
    if (a.kind() != b.kind()) return false;
    return visit(
        [&]<class C>(const C& c) {
            [[maybe_unused]] const C& d = b.get<C>();
            if constexpr (adds_shape<C>)
                return c.name == d.name;
            else if constexpr (std::is_same_v<C, SetTransform>)
                return c.object == d.object;
            else if constexpr (std::is_same_v<C, Duplicate>)
                return c.objects == d.objects;
            else if constexpr (std::is_same_v<C, SetMaterial>)
                return c.objects == d.objects && c.surfacing.filling == d.surfacing.filling;
            else if constexpr (std::is_same_v<C, Place> || std::is_same_v<C, EditPlacement>)
                return c.object == d.object && c.sketch == d.sketch && c.onto == d.onto;
            else if constexpr (std::is_same_v<C, WarpVolume>)
                return c.object == d.object && c.warp.axis == d.warp.axis;
            else if constexpr (std::is_same_v<C, SetWarp>)
                return c.object == d.object && c.step == d.step && c.warp.axis == d.warp.axis;
            else
                return false;
        },
        a);
}

bool is_replaced_try(const History& history, std::size_t branch)
{
    const History::Branch& tried = history.branches()[branch];
    if (tried.steps.size() != 1 || !tried.others.empty()) return false;
    const auto made_again = [&](const History::Step& step) {
        return differ_in_numbers_only(tried.steps.front().command, step.command);
    };
    for (std::size_t b = branch + 1; b < history.branches().size(); ++b) // the oldest are first
        if (history.branches()[b].from == tried.from &&
            made_again(history.branches()[b].steps.front()))
            return true;
    return tried.from < history.steps().size() && made_again(history.steps()[tried.from]);
}

} // namespace trivar
