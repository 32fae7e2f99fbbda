// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/intersection_lines.h"
#include "core/lines/level_drawing.h"
#include "core/lines/line_drawing.h"
#include "core/lines/mesh_shape.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// A ShapedMesh is what the lines of a mesh are found by: all that belongs to no view.
struct ShapedMesh {
    MeshShape shape;
    std::vector<KindLines> fixed; // see fixed_lines()
    float spacing = 0;            // of the points at which lines are looked at, at most
};
// `stretch` as in mesh_shape(). `copy_size`, above 0: the size of one of the bodies of which the
// mesh consists, by which the size of its lines is told in place of its own. 0.4 us per triangle.
ShapedMesh shaped_mesh(const Mesh& mesh, const LineDrawing& drawing,
                       const glm::mat3& stretch = glm::mat3(1), float copy_size = 0);

// The bodies that may hide a line.
struct HidingBodies {
    const RayScene& scene;      // the mesh's own, where it touches the line
    const glm::dmat4& to_scene; // from the space of the lines; a similarity
    // Whether another body hides a place of the scene; from any thread. None: nothing else does.
    std::function<bool(const glm::dvec3& p_world)> others = {};
};

// The strokes of the lines of a mesh in a view from its space, a list per kind: outlines of smooth
// patches and those sharp edges at which the surface turns away from sight, other sharp edges,
// borders, and further lines. A point is looked at from as far outside its triangle as this is from
// the smooth surface. 1 us per point.
std::vector<KindStrokes> mesh_strokes(const ShapedMesh& mesh, const LineDrawing& drawing,
                                      const DrawingView& view, const HidingBodies& bodies,
                                      const StrokeOptions& options = {});

// The strokes of lines at which surfaces go through each other, of a mesh of that size. A point is
// looked at from where the sides of both surfaces that face the eye meet. 1 us per point.
std::vector<Stroke> intersection_strokes(const IntersectionLines& lines, float size,
                                         const DrawingView& view, const HidingBodies& bodies,
                                         const StrokeOptions& options = {});

// The style of a kind of lines of a drawing: outlines and borders as told, all others finer.
LineStyle style_of(LineKind kind, const LineDrawing& drawing);

} // namespace trivar
