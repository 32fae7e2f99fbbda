// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/stages/evaluated.h"
#include "core/tiles/chart.h"
#include "core/tiles/limit_base.h"

namespace trivar {

// Returns the transform from the mesh of a part of the painted base to the base's model at rest, in
// whose space strokes of tiles are stored. `object` is the object that the base shows.
glm::dmat4 mesh_to_model(const EvaluatedObject& base, const Object& object, const Part& part);

// A TiledPiece is a part of the base of tiles, at rest: the mesh that it shows, and its cage, if it
// is shown as a subdivision surface.
struct TiledPiece {
    Ref<Mesh> mesh;
    glm::dmat4 to_model{1};
    LimitBase::Piece cage; // null: none
    bool operator==(const TiledPiece&) const = default;
};
using TiledPieces = std::vector<TiledPiece>;
TiledPieces pieces_of(const EvaluatedObject& base, const Object& object,
                      const std::vector<Part>& parts);

// Groups the parts of the base by the members of a procession.
std::map<int, std::vector<Part>> by_member(const EvaluatedObject& base);

// The limit surface of pieces that all have a cage, if there is one.
struct FoundLimit {
    Ref<LimitBase> base; // null: they have none
    std::string trouble; // why not, where they should
    bool operator==(const FoundLimit&) const = default;
};
// LimitBases keeps the last few of them.
class LimitBases {
public:
    FoundLimit operator()(const TiledPieces& pieces);

private:
    Kept<std::vector<LimitBase::Piece>, FoundLimit> known_;
};

// A RestToWorld takes points of a base's model at rest to where a part of it is shown, volumes and
// all, and normals to the side that is outside there. 10 nanoseconds where no volume bends it.
class RestToWorld {
public:
    RestToWorld(const Part& part, const glm::dmat4& to_model);
    SurfacePoint operator()(const SurfacePoint& at_rest) const;
    bool mirrors(const glm::dvec3& p_model) const; // about there
    double scale(const glm::dvec3& p_model) const; // metres in the world per metre on the model

private:
    DeformedPoint at(const glm::dvec3& p_model) const;

    Part part_;
    glm::dmat4 to_part_, straight_; // the second one is the whole way where nothing bends it
    glm::dmat3 normals_;
};
// One for each part.
std::vector<RestToWorld> ways_to_world(const TiledPieces& pieces, const std::vector<Part>& parts);
// Returns for each part whether it is shown as a mirror image of its rest.
std::vector<char> mirrored_parts(const TiledPieces& pieces, const std::vector<Part>& parts);

// The points of a base as its parts stand. `mirrored` is mirrored_parts(). O(#triangles).
BasePose pose_of(const TileBase& base, const std::vector<Part>& parts,
                 const std::vector<char>& mirrored);

} // namespace trivar
