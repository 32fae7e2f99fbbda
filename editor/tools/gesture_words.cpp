// SPDX-License-Identifier: GPL-3.0-or-later
// What a gesture says of itself.
#include "editor/tools/gesture.h"
#include "ui/widgets.h"

namespace trivar {
namespace {

bool is_plain(const std::string& typed)
{
    return typed.find_first_not_of("-.0123456789") == std::string::npos;
}

} // namespace

// What is typed stands as typed, with a mark where the next letter goes, and what it comes to.
std::string TransformGesture::amount_of(int number, double value) const
{
    const char* unit = kind_ == MotionKind::move ? " m" : kind_ == MotionKind::rotate ? "°" : "";
    const bool at_work = number == typed_.at();
    std::string said = ui::short_number(value) + unit;
    if (!typed_.open() || (!at_work && typed_.text(number).empty())) return said;
    std::string typed = typed_.text(number);
    const bool plain = is_plain(typed);
    if (typed.starts_with('=')) typed.erase(0, 1);
    if (at_work) typed += "|";
    return plain ? typed + unit : typed + " = " + said;
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
