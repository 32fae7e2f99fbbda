// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/bind.h"
#include "core/commands/command.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/cutting/peel.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/keep_shape.h"
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shade.h"
#include "core/commands/objects/shape.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/text.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/objects/view.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/paste.h"
#include "core/commands/placement/apply_shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/convert_lattice.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/commands/volumes/warp.h"

#include <array>

namespace trivar {

// EachOf does the same to the value of each kind of a list.
template <class List> struct EachOf;
template <class... All> struct EachOf<Types<All...>> {
    template <class F> static auto visit(F&& f, const Command& command)
    {
        using Result = std::common_type_t<std::invoke_result_t<F&, const All&>...>;
        static constexpr std::array<Result (*)(F&, const Command&), sizeof...(All)> calls{
            [](F& g, const Command& c) -> Result { return g(*c.as<All>()); }...};
        return calls[command.kind()](f, command);
    }
    // The results of f<kind>() of all kinds, in their order.
    template <class F> static auto results(F&& f)
    {
        return std::array{f.template operator()<All>()...};
    }
};

// The result of f(value), for the value of the command, whatever its kind is.
template <class F> auto visit(F&& f, const Command& command)
{
    return EachOf<CommandKinds>::visit(f, command);
}

// Calls f(value) to change the value of the command, whatever its kind is.
template <class F> void change(Command& command, F&& f)
{
    visit([&]<class C>(const C&) { f(*command.edit<C>()); }, command);
}

} // namespace trivar
