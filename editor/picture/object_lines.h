// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/lines/drawing_layer.h"
#include "core/lines/mesh_drawing.h"
#include "core/rays/ray_scene.h"
#include "core/stages/evaluated.h"
#include "gpu/curve.h"
#include "gpu/picture.h"

#include <tuple>
#include <vector>

namespace trivar {

// ObjectLines draws objects in lines, as they are seen from a camera. What belongs to no view is
// kept by mesh, and the lines of the last few views.
class ObjectLines {
public:
    // The curves of an object; `wider` as in VolumeLines. Parts that are drawn from tiles have
    // none, and others are deformed. The first view of a mesh costs 0.4 us per triangle, each
    // further one 10 ns per triangle and 1 us per point of its lines.
    const std::vector<gpu::Curve>& operator()(const EvaluatedObject& object,
                                              const LineDrawing& drawing, const Camera& camera,
                                              float wider);
    // The lines of an object as layers of a drawing, one per kind of line and part.
    std::vector<DrawingLayer> layers(const EvaluatedObject& object, const LineDrawing& drawing,
                                     const Camera& camera);
    // Changes instances of an object so that it is paper, or removes them where only its lines are
    // drawn.
    void draw_on(std::vector<gpu::Instance>& instances, const LineDrawing& drawing);

private:
    std::vector<gpu::Curve> lines_of(const EvaluatedObject& object, const LineDrawing& drawing,
                                     const Camera& camera, float wider);
    // Calls use(kind, lines, placed) for the lines of each kind of each part.
    void each_kind(const EvaluatedObject& object, const LineDrawing& drawing, const Camera& camera,
                   float wider, auto&& use);

    using ShapeKey = std::tuple<Ref<Mesh>, float, MoreLines, glm::mat3>;
    using PartPlaces = std::vector<std::pair<Ref<Mesh>, glm::dmat4>>;
    Recent<ShapeKey, Ref<ShapedMesh>> shapes_;
    Recent<Ref<Mesh>, Ref<RayMesh>> rays_;
    Recent<std::pair<std::size_t, glm::vec3>, Ref<std::vector<Material>>> papers_{16}; // by count
    Recent<std::tuple<PartPlaces, LineDrawing, Camera, int>, std::vector<gpu::Curve>> known_{16};
};

} // namespace trivar
