// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/joined_cages.h"
#include "core/limit/limit_surface.h"
#include "core/tiles/tile_base.h"

namespace trivar {

// A LimitBase is the limit surface on which tiles are painted where their base is shown as a
// subdivision surface, with triangles that lie on it: these find places by rays and lead
// straightest ways to them, and the surface itself says where a tile stands.
class LimitBase {
public:
    struct Piece {
        Ref<Mesh> cage;
        glm::dmat4 to_model{1};
        bool operator==(const Piece&) const = default;
    };
    // Throws Rejected as LimitSurface does. About 20 microseconds per face of the cages.
    explicit LimitBase(std::span<const Piece> pieces);

    const LimitSurface& surface() const { return surface_; }  // of all pieces, in the model's space
    const TileBase& triangles() const { return *triangles_; } // one of its pieces for each of these
    // Finds the place on the surface that is nearest to one on the triangles. About 2 microseconds.
    ChartPlace place(const SurfacePlace& at) const;
    std::size_t piece_of(std::uint32_t chart) const { return cages_.piece_of(chart); }

private:
    LimitBase(std::span<const Piece> pieces, const std::vector<Mesh>& ready);
    JoinedCages cages_;
    LimitSurface surface_;
    int cells_ = 1; // along each side of a chart, two triangles each
    std::unique_ptr<const TileBase> triangles_;
};

} // namespace trivar
