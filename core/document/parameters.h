// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>

// The numbers of a document that change in time where they have keys, by name: the fields of the
// commands that set them, joined by dots, lists and vectors by numbers from 0 and x, y, z, w:
// "transform.translation.z", "placement.width_profile.2.y", "shaping.0.press.radius". Switches
// count as 0 and 1. What asks for whole numbers, files or choices stays as it is, and so do the
// stroke and what itself says how something goes in time.

namespace trivar {

struct Parameter {
    std::string name;
    double value = 0;
    double lo = 0, hi = 0; // inclusive
    bool is_switch = false;
    bool operator==(const Parameter&) const = default;
};

// All that the object has at present, in the order of the panels.
std::vector<Parameter> parameters(const Object& object);
// Those of the scene itself: "render.exposure", "camera.NAME.eye.x" of a kept view.
std::vector<Parameter> scene_parameters(const Document& document);

// A new value for some of them: nothing where it stays.
using NewValue = std::function<std::optional<double>(const std::string& name)>;
// Values beyond a range are taken to its end, and none makes a scale 0. Names that are not there
// count for nothing.
Object with_values(Object object, const NewValue& value);
Document with_scene_values(Document document, const NewValue& value);

// The document as its tracks have it at that frame; objects without tracks keep their pointer. To
// do it again changes nothing. O(numbers of what has tracks).
Document document_at(const Document& document, double frame);

} // namespace trivar
