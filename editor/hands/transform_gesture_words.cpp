// SPDX-License-Identifier: GPL-3.0-or-later
// What a gesture says of itself.
#include "editor/hands/transform_gesture.h"
#include "ui/widgets.h"

namespace trivar {

std::string TransformGesture::amount_of(int number, double value) const
{
    const char* unit = kind_ == MotionKind::move ? " m" : kind_ == MotionKind::rotate ? "°" : "";
    return typed_.words(number, unit, ui::short_number(value) + unit);
}

std::string TransformGesture::amount() const
{
    const Motion m = motion();
    const std::vector<int> axes = named_axes();
    const Grip grip = constraint_.grip;
    std::string text;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const int axis = axes[i];
        if (i > 0) text += "   ";
        if (kind_ == MotionKind::scale && grip == Grip::plane)
            text += constraint_.axis == 0 ? "Y Z " : constraint_.axis == 1 ? "X Z " : "X Y ";
        else if (kind_ == MotionKind::move || grip != Grip::none)
            text += std::string(1, "XYZ"[axis]) + " ";
        if (kind_ == MotionKind::scale) text += "× ";
        text += amount_of(static_cast<int>(i), kind_ == MotionKind::move     ? m.offset[axis]
                                               : kind_ == MotionKind::rotate ? m.angle_deg
                                                                             : m.factors[axis]);
    }
    return text;
}

std::string TransformGesture::words() const
{
    const char* verb = kind_ == MotionKind::move     ? "Move "
                       : kind_ == MotionKind::rotate ? "Rotate "
                                                     : "Scale ";
    const bool along = constraint_.grip != Grip::none;
    const char* whose = along && choices_.orientation == Orientation::local  ? "local "
                        : along && choices_.orientation == Orientation::view ? "view "
                                                                             : "";
    return std::string(verb) + whose + amount();
}

} // namespace trivar
