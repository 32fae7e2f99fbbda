// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <optional>
#include <string>

namespace trivar {

// A FollowedView is the kept view through which the window looks: where it has keys the camera
// follows the frames, until a hand moves it.
struct FollowedView {
    std::string name;
    std::optional<Camera> shown = {}; // as it was last
};

// The camera for a window's view of that size: the kept view's in the document; or the given camera
// where a hand has moved it, and then no view is followed any more. The render camera is followed
// so that the whole of a picture of `picture_px` is seen; 0: of the shape in which it was kept.
Camera followed(std::optional<FollowedView>& view, const Document& document, Camera camera,
                glm::dvec2 size_px, glm::dvec2 picture_px = glm::dvec2(0));

} // namespace trivar
