// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

namespace trivar::ui {

// Handles the part common to all fields whose values are dragged in a picture; it is called after
// the picture's button and the drag. A click may hold the mouse button on; after a double click
// that dragged nothing the next number field takes the typed text; Esc ends the drag.
//   edit  the effect of the drag
//   held  whether a value is in the hand
// Returns the resulting edit.
Edit after_drag(Edit edit, bool held);

// The index of the point that is seen nearest to the mouse, within a reach in pixels; -1: none is.
template <class Point, class Plot>
int point_at(const std::vector<Point>& points, const Plot& plot, glm::vec2 mouse, float reach)
{
    int nearest = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float distance = glm::distance(plot.seen(points[i]), mouse);
        if (distance > reach) continue;
        reach = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

} // namespace trivar::ui
