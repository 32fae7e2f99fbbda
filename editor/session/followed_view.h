// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <optional>
#include <string>

namespace trivar {

// The kept view that the window looks through: where it has keys the camera goes with the frames,
// till a hand moves it.
struct FollowedView {
    std::string name;
    std::optional<Camera> shown = {}; // as it was last
};

// The camera for a picture of that size: the view's as the document has it, or the one it is
// where a hand moved it, and then none is followed any more.
Camera followed(std::optional<FollowedView>& view, const Document& document, Camera camera,
                glm::dvec2 size_px);

} // namespace trivar
