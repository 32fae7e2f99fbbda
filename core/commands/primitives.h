// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/material.h"
#include "core/document/fields/primitive_fields.h"

namespace trivar {

// Adds one object; its id is the document's next_id.
template <class Shape> struct AddShape {
    static constexpr std::string_view verb = FieldsOf<Shape>::verb,
                                      summary = FieldsOf<Shape>::summary;
    std::string name{FieldsOf<Shape>::name};
    Shape shape;
    Transform transform = {};
    std::optional<Surfacing> material = {};
    bool operator==(const AddShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        FieldsOf<Shape>::fields(c.shape, field);
        field("transform", c.transform, "where it stands");
        field("material", c.material, "one material over all of it; left out: nearly white");
    }
};
using AddPlane = AddShape<PlaneShape>;
using AddBox = AddShape<BoxShape>;
using AddSphere = AddShape<SphereShape>;
using AddCylinder = AddShape<CylinderShape>;
using AddTorus = AddShape<TorusShape>;
using AddMoebius = AddShape<MoebiusShape>;
using AddTeapot = AddShape<TeapotShape>;

} // namespace trivar
