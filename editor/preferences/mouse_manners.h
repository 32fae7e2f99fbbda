// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar {

// MouseManners say how a person's mouse or trackpad moves the camera.
struct MouseManners {
    std::string device = "automatic"; // what turns the wheel: "mouse", "trackpad"
    std::string emulation = "alt"; // makes the left button the middle one: "super", "space", "none"
    std::string orbit_about = "cursor"; // what it turns about: "selection", "origin"
    bool zoom_to_cursor = true;         // else to the middle of the picture
    bool reversed_zoom = false;
    double orbit = 1, pan = 1, zoom = 1; // speeds, times the usual
    bool operator==(const MouseManners&) const = default;
};

} // namespace trivar
