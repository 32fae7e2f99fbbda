// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/level_drawing.h"
#include "core/lines/line_drawing.h"
#include "core/lines/mesh_shape.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// A ShapedMesh is what the lines of a mesh are found by: all that belongs to no view.
struct ShapedMesh {
    MeshShape shape;
    std::vector<KindLines> fixed; // see fixed_lines()
};
// `stretch` as in mesh_shape(). 0.4 us per triangle.
ShapedMesh shaped_mesh(const Mesh& mesh, const LineDrawing& drawing,
                       const glm::mat3& stretch = glm::mat3(1));

// The bodies that may hide a line.
struct HidingBodies {
    const RayScene& scene;
    const glm::dmat4& to_scene; // from the mesh's space; a similarity
};

// The strokes of the lines of a mesh in a view from its space, a list per kind: outlines of smooth
// patches and those sharp edges at which the surface turns away from sight, other sharp edges,
// borders, and further lines. A point is looked at from as far outside its triangle as this is from
// the smooth surface. 1 us per point.
std::vector<KindStrokes> mesh_strokes(const ShapedMesh& mesh, const LineDrawing& drawing,
                                      const DrawingView& view, const HidingBodies& bodies,
                                      const StrokeOptions& options = {});

// The style of a kind of lines of a drawing: outlines and borders as told, all others finer.
LineStyle style_of(LineKind kind, const LineDrawing& drawing);

} // namespace trivar
