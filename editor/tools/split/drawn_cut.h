// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/split/cutting.h"

#include <optional>
#include <string>

namespace trivar {

// A DrawnWay is the line that a hand drew over an object, to cut it there.
struct DrawnWay {
    std::vector<glm::dvec2> points_px; // of the picture
    Camera camera;
    glm::dmat4 own_to_world{1}; // of the object
    glm::dvec3 middle{0};       // of the object, in the world: where the stroke is taken to lie
    // The state of the object that it was drawn over, as in PlainCut.
    std::vector<glm::dvec3> opened = {};
    bool parted = false;
};

// The cut through all that is seen under a straight line from the first point to the last one, or
// under the way itself, smoothed: a surface through the eye. What is seen above a line from left to
// right is above. Nothing, and why: the line is too short, or the way turns back over its chord.
std::optional<PlainCut> cut_along_line(const DrawnWay& way, std::string* why = nullptr);
std::optional<PlainCut> cut_along_way(const DrawnWay& way, std::string* why = nullptr);

// The same surfaces with above and below of one exchanged.
Cutting flipped(Cutting cutting, std::size_t number);

} // namespace trivar
