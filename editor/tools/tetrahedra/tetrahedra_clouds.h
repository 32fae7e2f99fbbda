// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_basis.h"
#include "core/simplex/simplex_domain.h"
#include "editor/hands/motion_gesture.h"
#include "editor/hands/parts_tool.h"
#include "gpu/picture.h"

#include <optional>

namespace trivar {

// TetrahedraClouds are the knots of the selected volume's domain, for the tool that works on it: a
// click on a vertex shows its cloud, a drag on a knot moves it, as far as no clouds cross.
class TetrahedraClouds : public Tool, public PartsTool {
public:
    TetrahedraClouds() : Tool({}) {}
    ToolState state() const override { return {.busy = gesture_.going()}; }
    PartsTool* parts() override { return this; }
    bool grab(Session& session, MotionKind kind) override; // the knot is moved, or its cloud scaled
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session& session) override;
    void cancel(Session& session) override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    std::vector<Hint> hints(const Session& session) const override;
    int picks() const { return picks_; } // how often another vertex or knot was picked
    // cloud_room() at the picked vertex; nothing: none is picked.
    std::optional<double> room() const { return vertex_ ? std::optional(room_) : std::nullopt; }

private:
    void follow(const Session& session);
    void pick(int vertex, int knot);
    void pick_none();
    void begin(const ViewportInput& input, const Camera& camera, const GizmoHandle& handle,
               MotionKind kind);
    Command wanted();
    std::vector<gpu::Line> lines(const ui::Theme& theme) const;
    gpu::Translucent region_veil(const ui::Theme& theme) const;
    glm::dvec3 world(const glm::dvec3& p) const;
    const SimplexDomain<3>& domain() const { return basis_->domain(); }

    Id object_ = 0;
    Ref<SimplexBasis<3>> basis_;
    glm::dmat4 to_world_{1};
    glm::dmat3 axes_{1};
    int picks_ = 0;
    std::optional<int> vertex_; // picked
    glm::dvec3 at_{0};          // where it is
    int knot_ = 0;              // of it, taken last; 0: none
    std::vector<int> cells_;    // round it
    double room_ = 1;
    std::vector<std::vector<glm::dvec3>> region_; // in which the knot may be
    std::optional<int> hovered_;
    int hovered_knot_ = 0;
    MotionGesture gesture_;
    Ref<SimplexBasis<3>> before_; // as the gesture began
    bool stopped_ = false;        // it would have crossed
    TetrahedraCloud cloud_;       // wanted last
    std::optional<MotionKind> grabbing_;
};

} // namespace trivar
