// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/commands/field.h"

namespace trivar {

// Each adds one object; its id is the document's next_id.
struct AddPlane {
    static constexpr std::string_view verb = "add_plane", summary = "Add a plane in z = 0.";
    std::string name = "Plane";
    PlaneShape shape;
    Transform transform;
    bool operator==(const AddPlane&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("size", c.shape.size, "along X and Y, metres", positive);
        field("segments", c.shape.segments, "along X and Y", between(1, 2000));
        field("transform", c.transform, "where it stands");
    }
};
struct AddBox {
    static constexpr std::string_view verb = "add_box", summary = "Add a box.";
    std::string name = "Box";
    BoxShape shape;
    Transform transform;
    bool operator==(const AddBox&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("size", c.shape.size, "along X, Y and Z, metres", positive);
        field("segments", c.shape.segments, "along X, Y and Z", between(1, 500));
        field("transform", c.transform, "where it stands");
    }
};
struct AddSphere {
    static constexpr std::string_view verb = "add_sphere", summary = "Add a sphere.";
    std::string name = "Sphere";
    SphereShape shape;
    Transform transform;
    bool operator==(const AddSphere&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("radius", c.shape.radius, "metres", positive);
        field("segments", c.shape.segments, "around the axis", between(3, 2000));
        field("rings", c.shape.rings, "from pole to pole", between(2, 1000));
        field("transform", c.transform, "where it stands");
    }
};
struct AddCylinder {
    static constexpr std::string_view verb = "add_cylinder", summary = "Add a closed cylinder.";
    std::string name = "Cylinder";
    CylinderShape shape;
    Transform transform;
    bool operator==(const AddCylinder&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("radius", c.shape.radius, "metres", positive);
        field("height", c.shape.height, "metres", positive);
        field("segments", c.shape.segments, "around the axis", between(3, 2000));
        field("stacks", c.shape.stacks, "along the axis", between(1, 2000));
        field("transform", c.transform, "where it stands");
    }
};
struct AddTorus {
    static constexpr std::string_view verb = "add_torus", summary = "Add a torus.";
    std::string name = "Torus";
    TorusShape shape;
    Transform transform;
    bool operator==(const AddTorus&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("radius", c.shape.radius, "of the middle circle, metres", positive);
        field("tube", c.shape.tube, "radius of the tube, metres", positive);
        field("segments", c.shape.segments, "around the axis and round the tube", between(3, 2000));
        field("transform", c.transform, "where it stands");
    }
};
struct AddMoebius {
    static constexpr std::string_view verb = "add_moebius", summary = "Add a Moebius band.";
    std::string name = "Moebius band";
    MoebiusShape shape;
    Transform transform;
    bool operator==(const AddMoebius&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("radius", c.shape.radius, "of the middle circle, metres", positive);
        field("width", c.shape.width, "metres", positive);
        field("segments", c.shape.segments, "around the axis and across", between(1, 2000));
        field("transform", c.transform, "where it stands");
    }
};
struct AddTeapot {
    static constexpr std::string_view verb = "add_teapot", summary = "Add the Utah teapot.";
    std::string name = "Teapot";
    TeapotShape shape;
    Transform transform;
    bool operator==(const AddTeapot&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name in the outliner");
        field("height", c.shape.height, "metres", positive);
        field("resolution", c.shape.resolution, "samples along each side of its 32 patches",
              between(1, 64));
        field("transform", c.transform, "where it stands");
    }
};

} // namespace trivar
