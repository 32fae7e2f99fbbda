// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/handles.h"
#include "ui/option_bar.h"

namespace trivar {

// A HandleChoice says which handles of a placed object are shown; all tools share it.
enum class HandleChoice { all, stroke, sizes, none };

// The handles of the one selected object on a stroke, by the kinds of their keys: "stroke", places
// of the stroke; "width" and "height", the rims and the roof of its volume, a handle per point of
// their profiles (of a rim 2 x point, and 1 more on the left one); "across" of the height across,
// "map" of the height map, row by row; "rise" of the rise, up a corner of the volume; "start" and
// "end" of the model on the stroke; "contact", the level that lies on the scene; "sunk", how deep
// the floor is sunk under it. A size that is seen end-on, like heights from the view of the stroke,
// stands on a stalk. `scale`: of the interface.
std::vector<Handle> placement_handles(const Session& session, HandleChoice choice, double scale);
// The pixel of the window at which the legend of such an object begins; their words leave it free.
float end_of_words(const ui::Theme& theme, const ViewportInput& input);
// The option to choose handles, where an object with handles is selected.
std::optional<ui::Option> handles_option(const Session& session, const ui::Theme& theme,
                                         HandleChoice& choice);

} // namespace trivar
