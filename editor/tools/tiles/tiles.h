// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tiles.h"
#include "editor/hands/model_tool.h"
#include "editor/hands/painted_surface.h"
#include "editor/hands/parts_tool.h"
#include "editor/hands/tool.h"
#include "editor/tools/tiles/strand_handles.h"
#include "editor/tools/tiles/tile_hand.h"
#include "editor/tools/tiles/tiles_between.h"
#include "ui/option_bar.h"

namespace trivar {

// A brush that paints copies of the selected object onto whatever is under it, and combs, resizes,
// raises, colours, morphs or erases those that are there; and a hand for single ones. What is seen
// is the proposal; a stroke is one step.
class TilesTool : public Tool, public PartsTool, public ModelTool {
public:
    using Tool::Tool;
    ToolState state() const override;
    PartsTool* parts() override { return this; }
    ModelTool* models() override { return this; }
    void take_read(Session& session, const TileFile& model) override;
    std::vector<std::string> chosen_models(const Session& session) const override;
    // Makes a click cover the object under it from now on, as with the brush Cover.
    void choose_cover(const TileCover& cover)
    {
        covers_ = true;
        cover_ = cover;
    }
    void choose_mirror(TileMirror mirror) { settings_.mirror = mirror; }
    // Sets the brush of strokes from now on.
    void choose_brush(TileBrush brush)
    {
        covers_ = false;
        settings_.brush = brush;
    }
    void choose_model(Session& session, const std::string& file, bool also) override;
    void fit_model(const TileFit& fit) override;
    std::optional<std::string> take_wanted() override;
    bool grab(Session& session, MotionKind kind) override;
    bool choose(Session& session, PartChoice choice) override;
    bool remove(Session& session) override;
    void take_keys(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    bool resize(Session& session, double factor) override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    struct Gesture {
        Id layer = 0; // 0: it begins with the stroke
        Id base = 0;
        TileStroke stroke;
        std::vector<TileFile> files = {};    // of which the layer is made, where it is 0
        std::optional<TileCover> cover = {}; // in place of the stroke
        glm::dvec2 begun_px{0};
        std::size_t moves = 0;    // number of times that earlier samples were replaced
        std::size_t proposed = 0; // number of samples and moves of the last proposal
        double overlap = 0;       // of a layer that begins
        bool over = false;        // the button was let go while its model was being read
        bool joins = false;       // where it turns out to be a click: by a line to the last stroke
        glm::dvec2 last_px{0};    // of the mouse
        double last_s = 0, speed_px = 0; // pixels per second, smoothed
    };
    // The quantity that the strength of a stroke, or the size of its tiles, follows.
    enum class Follows { nothing, speed };           // what makes it weaker
    bool begins_layer(const Session& session) const; // with a model that is not in the scene yet
    bool lays_strands() const { return !covers_ && settings_.brush == TileBrush::strand; }
    bool lays() const; // the brush makes tiles where there are none
    void cover_options(std::vector<ui::Option>& options, const ui::Theme& theme);
    void heading_options(std::vector<ui::Option>& options, const ui::Theme& theme);
    void stroke_options(std::vector<ui::Option>& options, const ui::Theme& theme);
    // Return the object to paint with, and the base under the mouse; 0: none.
    Id tile(const Session& session) const;
    Id base_under(const Session& session, const ViewportInput& input) const;
    void take_back_files(const Session& session); // where the stroke that used them was undone
    void mix(Session& session, Id layer, const TileFile& other);
    void find_place(const Session& session, const ViewportInput& input);
    void begin(Session& session, const ViewportInput& input);
    void go_on(Session& session, const ViewportInput& input);
    void extend_stroke(Session& session, const ViewportInput& input);
    Command painting() const; // by the gesture, so far
    void finish(Session& session);
    // Replaces the stroke by a straight line in the picture.
    void straighten(Session& session, glm::dvec2 from_px, const StrokeSample& to);
    double pressure_of(const StrokeSample& move);
    bool joins_last_stroke() const; // a click with Shift would draw a line to it
    bool picks_point(const ViewportInput& input);
    bool uses_hand(const Session& session) const;
    void use_hand(Session& session, const ViewportInput& input);
    void move_by_hand(Session& session, const ViewportInput& input);
    void hand_overlay(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const;
    void add(const SurfaceHit& hit, double time_s, double pressure);
    double radius(const Session& session) const; // metres in the world
    double size(const Session& session) const;

    // The files of the models that the next stroke begins a layer with, mixed where there are
    // several, unless something is selected.
    std::vector<std::string> files_;
    std::vector<std::string> wanted_; // those still to be read, the first one next
    bool reading_ = false;            // one of them is being read
    Id mixing_ = 0;      // the layer that is mixed with what is read; 0: the gesture waits for it
    double overlap_ = 0; // of the layer that the next stroke begins
    std::optional<BegunLayer> begun_;
    TileStroke settings_{}; // all but lengths and the colour
    bool covers_ = false;   // a click covers what is under it, and there are no strokes
    TileCover cover_{.pattern = TilePattern::grid}; // all but its size
    double radius_ = 0, size_ = 0; // metres in the world; 0: in proportion to the base
    PaintedSurface surface_;
    Id under_ = 0;                  // what the brush is over
    std::optional<SurfaceHit> hit_; // under the mouse
    std::optional<Gesture> gesture_;
    int strokes_ = 0; // number of strokes so far, which become their seeds
    Follows follows_ = Follows::nothing;
    glm::dvec3 color_{0.8, 0.12, 0.04}; // of the brush color
    std::optional<StrokeEnd> last_end_;
    std::optional<PickedPoint> point_; // none: the origin of the base
    bool picking_ = false;             // the next click picks it
    TileHand hand_;
    Id hand_layer_ = 0;
    long hand_evaluation_ = 0;            // in which its tiles were found
    std::optional<MotionKind> asked_;     // by a key, to begin as soon as the mouse is known
    bool by_key_ = false, enter_ = false; // a click ends the hand's motion, or Enter
    std::optional<SeenTile> under_hand_;
    StrandHandles strands_; // of the selected layer, while the brush lays strands
};

} // namespace trivar
