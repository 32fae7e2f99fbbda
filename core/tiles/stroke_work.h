// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/tiles/laid_tiles.h"
#include "core/tiles/layout.h"
#include "core/tiles/mirror_plane.h"

#include <optional>

namespace trivar {

// A StrokeWork lays strokes on a base, one after another; it can return to its state before one of
// them. For Layouter, which decides which are laid again.
class StrokeWork {
public:
    // `cube`: of the grid in which tiles are found; the order of tiles near a place follows it.
    StrokeWork(const TileBase& base, double cube);

    // Whom it asks and tells from now on; both must live until the next call.
    void attend(const Progress& progress, const Lazy<TileCurvature>* curvature);
    // Works off the next stroke. Throws Cancelled, and then serves for nothing any more.
    void work_off(const TileStroke& stroke, int number);
    // Continues the stroke laid last, if its samples have changed and nothing else, and it scatters
    // tiles: tiles of unchanged dabs stay. `before` is the state before the stroke.
    struct State;
    bool can_go_on() const { return dab_.has_value(); }
    void go_on(const State& before, const TileStroke& stroke, int number);

    // All that strokes change. A copy costs O(#runs + #strands + #tracks).
    struct State {
        Runs<Tile> tiles;
        Runs<char> gone;
        std::size_t near = 0; // number of tiles that were laid, with those that are gone
        int tries = 0;
        TileLayout out; // without its tiles
    };
    State state() const { return {laid_.tiles, laid_.gone, laid_.near.size(), tries_, out_}; }
    // Returns to an earlier state of this work.
    void go_back_to(const State& state);
    TileLayout result();

private:
    // A Wanted is a tile that a brush asks for at one place. `ahead` is the direction of the stroke
    // there.
    struct Wanted {
        std::uint32_t seed;
        SurfacePlace at;
        glm::dvec3 ahead;
        double time_s, pressure;
        double along = -1; // on the last track; -1: on none
    };
    // A Dab is the place where the last dab of the last stroke begins.
    struct Dab {
        State before;
        std::uint32_t made;
        double since; // length since the dab before
        std::size_t step;
    };
    struct Located {
        std::vector<SurfacePoint> points;
        std::vector<std::optional<SurfacePlace>> places;
        double reach = -1;
    };
    struct Left { // of a run from which brushes have removed tiles
        Runs<Tile>::Run tiles;
        Runs<char>::Run gone;
        Runs<Tile>::Run left;
    };
    Runs<Tile> left();
    std::vector<StrokeStep> path_of(const TileStroke& stroke);
    const std::vector<std::optional<SurfacePlace>>& located(const TileStroke& stroke);
    double reach_of(const TileStroke& stroke) const;
    std::vector<StrokeStep> image_of(const TileStroke& stroke,
                                     const std::vector<StrokeStep>& path) const;
    std::uint32_t next_seed(const TileStroke& stroke);
    void lay(const TileStroke& stroke, int number, Wanted wanted, bool avoiding);
    bool has_room(const SurfacePlace& at, double room) const;
    bool add(const Tile& tile);
    std::optional<SurfacePlace> on_the_plane(const MirrorPlane& plane, const SurfacePlace& at,
                                             double near) const;
    glm::dvec3 heading_of(const TileStroke& stroke, const Wanted& wanted);
    void scatter(const TileStroke& stroke, int number, std::size_t step, double since);
    void line(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path);
    void begin_tracks(const TileStroke& stroke, const std::vector<StrokeStep>& path, double step);
    void strand(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path);
    void fill(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path);

    const TileBase& base_;
    const Progress* progress_ = nullptr;
    const Lazy<TileCurvature> estimate_; // where nobody has one
    const Lazy<TileCurvature>* curvature_ = nullptr;
    TileLayout out_; // without its tiles
    LaidTiles laid_;
    std::vector<StrokeStep> path_;      // of the last stroke
    std::optional<Dab> dab_;            // none: the last stroke is none that scatters
    int track_ = -1, image_track_ = -1; // of the line that is laid
    std::uint32_t made_ = 0;            // number of tiles that the present stroke tried to lay
    int tries_ = 0;                     // of all strokes
    Located located_;                   // the samples of the last stroke
    std::vector<Left> left_;            // by run
};

} // namespace trivar
