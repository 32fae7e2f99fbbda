// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/document.h"
#include "core/evaluation/bending.h"
#include "core/evaluation/shapes.h"
#include "core/placement/round.h"
#include "core/placement/shaper.h"
#include "core/refinement/refine.h"

#include <set>

namespace trivar {

// What a stroke sees: the parts of the objects it may fall on.
struct Support {
    Id id = 0;
    Part part;
    bool operator==(const Support&) const = default;
};

struct Walk; // core/evaluation/walk.h

// What an object is after it was laid along its stroke.
struct Laid {
    Ref<Placement> placement; // null: rejected
    Ref<ShapedVolume>
        shaped;              // how that came from what the stroke gave; null where nothing was done
    Ref<RayScene> scene;     // that the stroke fell on
    std::vector<Part> parts; // in the world
    Ref<Journey> journey;    // null: it does not travel
    Ref<Walk> walk = nullptr; // null: its feet are not locked to its travel
    std::string rejected;
    Ref<Refined> refined = nullptr; // null: the parts have the triangles of the model
    std::string not_refined = {};   // why, where they were to be
};

// Whether a box and the volume overlap in the picture that the stroke was drawn in, where a stroke
// meets all that it meets. Never false where the box reaches behind the camera.
bool in_the_way(const Box& box, const Placement& placement, const Camera& camera);

// One of a procession, or the only one.
struct Member {
    Ref<Shape> posed; // null: as the model came
    Journey::Place place;
    bool operator==(const Member&) const = default;
};

// The volume as far as models at these places are on it, straight on beyond its ends or round once
// more.
Ref<Lattice> reaching(const Ref<Lattice>& volume, const Journey& journey,
                      const PlacementParameters& parameters,
                      const std::vector<Journey::Place>& places);

// The bounding-volume hierarchies of meshes that strokes may fall on, each built once.
class RayMeshes {
public:
    Ref<RayMesh> operator()(const Ref<Mesh>& mesh, Timings& timings); // stage: rays
    void keep_only(const std::set<Ref<Mesh>>& meshes);

private:
    std::map<Ref<Mesh>, Ref<RayMesh>> known_;
};

// Lays one object again and again, while its stroke, its parameters or the scene change, and keeps
// the last few results, the scene for rays, and how the meshes are sorted into the volume.
class Laying {
public:
    // `turned` is the object's own turn and size, before it is laid. Stages: rays, springs, lift
    // and volume, as place() names them, shape, and deform for what it lies on. `band`: what it
    // goes round, where it does. `shaping`: what is done to the volume then.
    Ref<Laid> operator()(const Ref<Shape>& shape, const glm::dmat3& turned,
                         const PlacementStep& step, const std::optional<Band>& band,
                         const std::vector<Ref<VolumeEdit>>& shaping,
                         const std::vector<Support>& supports, RayMeshes& ray_meshes,
                         Timings& timings, const Progress& progress = {});
    // Of what is laid; null where it rests and is alone.
    Ref<Journey> journey(const Ref<Laid>& at_rest, const Travel& travel,
                         const PlacementParameters& parameters);
    // The same with its members where they have gone, all in one volume, and posed. What rests is
    // as it was.
    Ref<Laid> moved(const Ref<Laid>& at_rest, const std::vector<Member>& members,
                    const glm::dmat3& turned, const Ref<Journey>& journey,
                    const PlacementParameters& parameters, const Ref<Walk>& walk);
    void add_meshes(std::set<Ref<Mesh>>& meshes) const; // that the kept results fell on

private:
    struct Known {
        Ref<Shape> shape;
        glm::dmat3 turned;
        PlacementStep step;
        std::vector<Ref<VolumeEdit>> shaping;
        std::vector<Support> supports;
        Ref<Placement> unshaped; // null: rejected
        Ref<Laid> laid;
    };
    Ref<RayScene> scene_of(const std::vector<Support>& supports, RayMeshes& ray_meshes,
                           Timings& timings);
    struct Moved {
        Ref<Laid> at_rest;
        std::vector<Member> members;
        Ref<Journey> journey;
        Ref<Walk> walk;
        Ref<Laid> laid;
    };
    void bend(Laid& laid, const Shape& shape, const glm::dmat3& turned);

    std::vector<Known> known_; // the latest first
    Shaper shaper_;
    std::vector<Support> scene_supports_;
    Ref<RayScene> scene_;
    Bending bending_;
    std::vector<Moved> moved_;                                 // the latest first
    std::vector<std::pair<Ref<Laid>, Ref<Journey>>> journeys_; // the latest first
};

} // namespace trivar
