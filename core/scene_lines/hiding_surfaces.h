// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// A HidingSurfaces is the surfaces of a scene that hide lines of other objects.
class HidingSurfaces {
public:
    struct Surface {
        Ref<RayMesh> mesh;
        glm::dmat4 to_world{1};
        int object = 0;
        int number = 0;                            // of the mesh in its object's shape
        double size = 0;                           // metres
        Ref<std::vector<Material>> materials = {}; // faces that blend hide nothing; null: all hide
    };
    // An Owner is whose lines are looked at: that its own surfaces hide them is not asked here.
    struct Owner {
        int object = 0;
        std::optional<int> number = {}; // that mesh of it alone; none: all of them
        double size = 0;                // metres
    };
    explicit HidingSurfaces(std::vector<Surface> surfaces);

    // Whether a surface lies between a place and the eye of a camera. What is nearer before it than
    // a thousandth of the sizes of both does not count, so that a box on a table keeps its lower
    // edges. In the world, metres; 1 us.
    bool hide(const glm::dvec3& p_world, const Owner& own, const Camera& camera) const;
    bool has_others(const Owner& own) const; // surfaces that are not its own

private:
    bool passes(const Hit& hit, const Owner& own) const;

    std::vector<Surface> surfaces_;
    RayScene scene_;
};

} // namespace trivar
