// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/material.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/primitive_fields.h"

namespace trivar {

// Adds one object; its id is the document's next_id.
template <class Shape> struct AddShape {
    static constexpr std::string_view verb = FieldsOf<Shape>::verb,
                                      summary = FieldsOf<Shape>::summary;
    static constexpr CommandNature nature{.icon = CommandIcon::add,
                                          .asked = Invocation::by_actions};
    std::string name{FieldsOf<Shape>::name};
    Shape shape;
    Transform transform = {};
    std::optional<Surfacing> material = {};
    bool operator==(const AddShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        spread(c.shape, field);
        field("transform", c.transform, "its position, rotation and scale");
        field("material", c.material, "one material over all of it; left out: nearly white");
    }
};
// The document with the object that such a command adds. Throws Rejected.
Document with_named(Document document, Object object);
// Return the size of a shape in words: "2 × 2 m", "radius 0.5 m".
std::string size_words(const PlaneShape& shape);
std::string size_words(const BoxShape& shape);
std::string size_words(const TeapotShape& shape);
std::string size_of_radius(double radius);
template <class Round>
requires requires(const Round& round)
{
    round.radius;
}
std::string size_words(const Round& shape)
{
    return size_of_radius(shape.radius);
}

template <class Shape> Document applied(Document document, const AddShape<Shape>& command)
{
    if constexpr (requires { check(command.shape); }) check(command.shape);
    return with_named(std::move(document), {.name = command.name,
                                            .source = command.shape,
                                            .transform = command.transform,
                                            .surfacing = command.material,
                                            .stroke = {}});
}
template <class Shape> StepTitle title(const AddShape<Shape>& c, const StepDocuments& step)
{
    const std::string made = step.made(), size = size_words(c.shape);
    return {"Add " + made, size == made ? "" : size}; // a folder of slices is called as its data
}

using AddPlane = AddShape<PlaneShape>;
using AddBox = AddShape<BoxShape>;
using AddSphere = AddShape<SphereShape>;
using AddCylinder = AddShape<CylinderShape>;
using AddTorus = AddShape<TorusShape>;
using AddMoebius = AddShape<MoebiusShape>;
using AddTeapot = AddShape<TeapotShape>;

} // namespace trivar
