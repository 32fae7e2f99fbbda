// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/placed_tile.h"
#include "editor/hands/motion.h"
#include "editor/hands/painted_surface.h"
#include "editor/hands/tool.h"
#include "editor/hands/typed_amounts.h"

#include <functional>
#include <optional>
#include <vector>

namespace trivar {

// A SeenTile is a painted tile as a layer shows it, and where it stands on its base at rest.
struct SeenTile {
    TilePatch patch;                         // in the world
    glm::dvec3 p_world{0}, n_world{0, 0, 1}; // of its middle on the base; unit
    double size_world = 0;
    Id object = 0; // of which it is a copy
    SurfacePoint at_rest;
};

// A TileHand holds single tiles of a layer, and moves, turns or scales them with the mouse. What it
// does is a stroke.
class TileHand {
public:
    // The tile that a ray meets first; nothing: none. `surface` finds where it stands on the base.
    static std::optional<SeenTile> under(const Session& session, Id layer, const Ray& ray,
                                         PaintedSurface& surface);
    const std::vector<SeenTile>& held() const { return held_; }
    bool holds(const SeenTile& tile) const;
    // Takes it in place of the others; `also`: beside them, or lets go of it.
    void take(const SeenTile& tile, bool also);
    void let_go() { held_.clear(); }
    void take_all(const Session& session, Id layer, PaintedSurface& surface);
    // Takes all tiles that are copies of the same objects as those that it holds, in a mix.
    void take_same(const Session& session, Id layer, PaintedSurface& surface);
    // Finds what it holds again after the layer was evaluated anew; what is gone it holds no more.
    void follow(const Session& session, Id layer, PaintedSurface& surface);

    // Begins to move, turn or scale what it holds.
    void begin(MotionKind kind, const Camera& camera, glm::dvec2 mouse_px);
    std::optional<MotionKind> motion() const { return motion_; }
    struct Steps {
        bool snap = false, fine = false;
    };
    void go_on(const Camera& camera, glm::dvec2 mouse_px, Steps held);
    // Returns the place at which its first tile is to be sought, pixels, while it moves.
    glm::dvec2 goal_px(const Camera& camera) const;
    // The stroke of what it has done so far; `goal`: where its first tile goes. Nothing: none yet.
    std::optional<TileStroke> stroke(const std::optional<SurfaceHit>& goal) const;
    void end(const std::optional<SurfaceHit>& goal); // what has moved is sought there from then on
    void drop() { motion_.reset(); }
    TypedAmounts& typed() { return typed_; }
    std::string amount() const; // "Turn 15 deg"

    // The rims of the tiles that it holds, over the picture.
    void paint(const ui::Theme& theme, const ViewportInput& input, const Camera& camera) const;
    static void paint_rim(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                          const SeenTile& tile, ui::Color color, float width);

private:
    // Takes the tiles of a layer that fit: their objects are known.
    void take_those(const Session& session, Id layer, PaintedSurface& surface,
                    const std::function<bool(Id object)>& fits);

    std::vector<SeenTile> held_;
    std::optional<MotionKind> motion_;
    glm::dvec2 from_px_{0}, mouse_px_{0}, middle_px_{0};
    double turned_deg_ = 0, factor_ = 1, travelled_px_ = 0;
    Steps steps_;
    TypedAmounts typed_; // an angle or a factor, in place of the mouse's
};

} // namespace trivar
