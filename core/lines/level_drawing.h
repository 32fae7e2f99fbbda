// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/camera.h"
#include "core/level/level_mesh.h"
#include "core/lines/drawing_layer.h"
#include "core/lines/level_lines.h"
#include "core/lines/line_ids.h"
#include "core/lines/strokes.h"
#include "core/silhouette/certified.h"
#include "core/silhouette/visibility.h"

#include <functional>
#include <span>

namespace trivar {

// A DrawingView says how voxels come into a picture.
struct DrawingView {
    glm::dmat4 to_image{1}; // voxels to pixels and depth, homogeneous; see strokes()
    ViewPoint from;
};
// The view of a camera; `to_world` maps the voxels of a grid of that size, affine and not singular.
DrawingView drawing_view(const Camera& camera, const glm::dmat4& to_world, const glm::ivec3& size);
// The same for what is in a box of another space, in place of voxels.
DrawingView drawing_view(const Camera& camera, const glm::dmat4& to_world, const Box& box);

// A DrawnLevel is a level as it is to be drawn.
struct DrawnLevel {
    std::string name;
    const LevelMesh& mesh;
    LevelSide side = LevelSide::above;
    LineStyle style = {};
    bool border = true; // also lines where the grid cuts the body off
    MoreLines more = {};
    const LevelLines* further = nullptr; // that `more` are found by; null: none of them
    // Levels at values nearby: a share of lines (more.amount) is then rather of those that are
    // there in these, too. None: all lines count alike.
    std::span<const LevelMesh> nearby = {};
    int certified_depth = -1; // as LevelDrawingOptions has it; the greater one counts
    // Whether what is no level of this field hides a place, voxels; from any thread. None: nothing.
    std::function<bool(const glm::vec3&)> hidden_by_others = {};
};

struct LevelDrawingOptions {
    StrokeOptions strokes = {};
    bool hide_each_other = false; // bodies hide what is behind them of other levels, too
    int certified_depth = -1; // of certified_silhouettes(); below 0: quick ones. However short the
                              // strokes of these are, none of them is left out
    int dash_rows = 0;        // of a DashTable that is used, without a proof; 0: connected lines
    // The ids of the lines of a layer by its name, kept from view to view; none: as they come.
    std::function<LineIds&(const std::string& layer)> ids = {};
    // The ids of the lines of a layer that its share of lines kept in the view before, so that they
    // stay while others are hardly longer; drawing sets them. It takes `ids` too. None: as they
    // come.
    std::function<std::vector<std::uint64_t>&(const std::string& layer)> kept = {};
    Progress progress = {}; // of certified silhouettes, called from any thread
};

// A ProofGaps is what a certified drawing is not proven for.
struct ProofGaps {
    std::size_t open = 0;       // boxes in which something may be missing
    std::size_t loose_ends = 0; // of curves, within the grid; 0 unless rounding hid a box
};

// The strokes of the silhouettes of a level, and those of its border. `others` are bodies that hide
// what is behind them, too; `gaps` are added to.
std::array<std::vector<Stroke>, 2>
level_strokes(const ScalarField<float>& field, const FieldHulls& hulls, const DrawnLevel& level,
              const DrawingView& view, const LevelDrawingOptions& options = {},
              std::vector<LevelBody> others = {}, ProofGaps* gaps = nullptr);

// The strokes of one kind of lines.
struct KindStrokes {
    LineKind kind;
    std::vector<Stroke> strokes;
};

// The strokes of the further lines of a level, a list per kind; what is hidden of them is found as
// for silhouettes.
std::vector<KindStrokes> further_strokes(const ScalarField<float>& field, const FieldHulls& hulls,
                                         const DrawnLevel& level, const DrawingView& view,
                                         const LevelDrawingOptions& options = {},
                                         std::span<const LevelBody> others = {});
// The style of further lines beside outlines of a style.
LineStyle finer(LineStyle style, const MoreLines& wanted);

// A LevelDrawing is the result: a layer per level, one more per kind of further lines, and how far
// it is proven, before a share of the lines is taken.
struct LevelDrawing {
    std::vector<DrawingLayer> layers;
    ProofGaps gaps;
};

// Draws levels of a field: silhouettes, what is hidden of them, strokes, ink.
LevelDrawing draw_levels(const ScalarField<float>& field, const FieldHulls& hulls,
                         std::span<const DrawnLevel> levels, const DrawingView& view,
                         const LevelDrawingOptions& options = {});

} // namespace trivar
