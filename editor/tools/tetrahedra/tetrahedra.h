// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/placement/place.h"
#include "core/commands/volumes/tetrahedra.h"
#include "editor/tools/tetrahedra/tetrahedra_clouds.h"
#include "editor/tools/tetrahedra/tetrahedra_points.h"
#include "editor/tools/tetrahedra/tetrahedra_round.h"
#include "ui/option_bar.h"

#include <optional>

namespace trivar {

// Works on a volume of tetrahedra: a ball pulls the control points of what stands in it, or a hand
// some of them, a brush lowers the continuity across faces or cuts them, a stroke refines, and
// knots of the domain are moved.
class TetrahedraTool : public Tool {
public:
    using Tool::Tool;
    enum class By { pull, points, crease, refine, knots };
    void choose(By by) { by_ = by; }

    ToolState state() const override;
    PartsTool* parts() override;
    void begin(Session& session) override;
    void take_keys(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    bool resize(Session& session, double factor) override;
    void cancel(Session& session) override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    struct Place {                    // on what stands in the volume
        glm::dvec3 world{0}, rest{0}; // and where that rests in the volume
    };
    struct Editing {
        Id object = 0;
        TetrahedraEdit edit;
        glm::dvec3 grabbed{0}; // world
        glm::dmat3 to_volume{1};
        double carried = 1; // how far a pull by 1 moves what was grabbed
    };
    // The tool for control points or for knots, where one of them is at work; else null.
    const Tool* inner() const;
    Tool* inner() { return const_cast<Tool*>(std::as_const(*this).inner()); }
    std::optional<Place> place_under(const Session& session, const ViewportInput& input) const;
    double radius(const Session& session) const; // metres in the volume
    void start(Session& session, const ViewportInput& input);
    void take_hold(const Session& session); // so that what a pull grabs goes with the mouse
    void go_on(Session& session, const ViewportInput& input);
    void pull_on(const Camera& camera, const ViewportInput& input);
    void draw_on(const Session& session, const ViewportInput& input);
    TetrahedraEdit edit_at(const TetrahedraShape& shape, const Place& place,
                           const Session& session) const;

    void add_layer_option(std::vector<ui::Option>& options, const ui::Theme& theme,
                          const TetrahedraShape& shape);
    void add_ball_options(std::vector<ui::Option>& options, const ui::Theme& theme,
                          const Session& session);
    void around_options(Session& session, const ui::Theme& theme, float width);

    By by_ = By::pull;
    PullBall ball_;
    TetrahedraPoints points_{ball_};
    TetrahedraClouds clouds_;
    Around around_ = Around::box;
    double shown_radius_ = 0; // in the field
    int depth_ = 3;           // of creases; the degree and more: a cut; 0: smooth again
    std::optional<Place> at_;
    GestureWith<Editing> gesture_;
};

} // namespace trivar
