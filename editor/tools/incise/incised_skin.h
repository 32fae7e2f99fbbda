// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"
#include "editor/hands/painted_surface.h"
#include "editor/session/session.h"

#include <array>
#include <optional>

namespace trivar {

// An IncisedSkin is the skin of one object as it is shown at a moment, and what of it lies where
// while all incisions are shut. It stays as it was while the session goes on; copies share what was
// built for them. Trees for rays are built when they are first needed.
class IncisedSkin {
public:
    // Looks at an object as it is shown now. The tree of the shut skin is kept while that stays.
    void look(const Session& session, Id object);
    const Ref<EvaluatedObject>& shown() const { return shown_; } // null: nothing
    bool empty() const { return parts_.empty(); }
    double diagonal() const; // of the model at rest, metres there

    // Finds the place where a ray meets the skin as seen, and its place on the shut skin. Nothing:
    // it misses, or meets a wall.
    std::optional<SurfaceHit> hit(const Ray& ray) const;
    // Finds the place where a ray would meet the skin if nothing stood open.
    std::optional<SurfaceHit> shut_hit(const Ray& ray) const;
    // Finds the place where a ray meets a wall or a floor as seen; its place on the shut skin is
    // that of the incision above it. Nothing: it meets something else first, or misses.
    std::optional<SurfaceHit> wall_hit(const Ray& ray) const;
    // Moves points of the shut skin, as if nothing stood open, onto the skin as seen; nothing where
    // there is none at most `reach` away along their normals. About 3 microseconds each.
    std::vector<std::optional<SurfaceHit>> seen(std::span<const SurfacePoint> at_rest,
                                                double reach) const;
    // The lines through a point of the shut skin along which u, and v, stay, each with the number
    // of its place there; empty where there are no texture coordinates.
    struct SeenUvLine {
        std::vector<SurfaceHit> places;
        std::size_t start = 0;
    };
    std::array<SeenUvLine, 2> uv_lines(const SurfacePoint& at_rest) const;
    // Returns the thickness of the body below points of the shut skin, metres on the model; 0: it
    // is open.
    std::vector<double> thickness(std::span<const SurfacePoint> at_rest) const;

private:
    struct SkinPart {
        std::size_t part = 0; // of shown_->whole()
        Ref<Mesh> shut;       // with the vertices of the part; null: not known, as it was refined
        Ref<Mesh> original;   // without walls
        glm::dmat4 shut_to_model{1}, shut_to_part{1};
        Ref<IncisedMesh> incised; // null: it has no walls, or they are not known
        std::uint32_t first_wall_face = 0xFFFFFFFF;
        Ref<Mesh> posed; // the original in its pose
        bool mirrors = false;
    };
    struct Trees {
        Ref<RayScene> seen, shut, inside;
        Ref<TileBase> rest;
    };
    std::optional<SurfaceHit> hit_of(const SkinPart& part, const Part& seen, const Mesh& rest,
                                     const RayScene& scene, const Hit& hit) const;
    SurfaceHit seen_place(const SurfacePlace& place) const;
    const RayScene& seen_scene() const;
    const RayScene& shut_scene() const;
    const TileBase& rest_base() const;

    Ref<EvaluatedObject> shown_;
    std::vector<SkinPart> parts_;
    std::vector<Part> shut_parts_;
    std::shared_ptr<Trees> trees_ = std::make_shared<Trees>();
};

} // namespace trivar
