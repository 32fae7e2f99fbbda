// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/incise/incision_snap.h"

namespace trivar {

// A IncisionStroke is the way of a hand over a skin, from which an incision becomes. The skin stays
// as it was when the hand began, so that the wound that opens does not swallow the stroke.
class IncisionStroke {
public:
    // `snaps`: to which its own ends are pulled; empty: nothing pulls.
    IncisionStroke(IncisedSkin skin, IncisionSnaps snaps, const SurfaceHit& from, glm::dvec2 at_px);

    struct HeldKeys {
        bool straight = false; // a straight line in the picture from where this began to be held
        bool along_uv = false; // that of the lines along U and V through its start that is nearer
        double scale = 1;      // of the interface
    };
    // Takes more of the hand's way; what misses the skin is left out. Returns whether it changed.
    bool take(const Camera& camera, const std::vector<StrokeSample>& moves, const HeldKeys& keys);
    bool is_click() const { return !moved_; } // the hand never left the place where it began

    // The points of the incision: smoothed where they were drawn freely, with few digits; fewer
    // than two: it is too short.
    std::vector<SurfacePoint> points() const;
    std::vector<glm::dvec3> way_world() const;            // that the hand went
    double length() const { return length_of(points()); } // metres on the model
    double scale() const
    {
        return hits_.front().hit.scale;
    } // metres in the world per metre on the model
    const std::optional<IncisionSnap>& end() const { return at_end_; } // that it is pulled to
    bool lacks_uv() const; // it was to go along a UV line, but there is none
    const IncisedSkin& skin() const { return skin_; }

private:
    struct SkinSample {
        SurfaceHit hit;
        bool free = true; // drawn freely: smoothed
    };
    void add(const Camera& camera, glm::dvec2 p_px, bool free);
    void go_straight(const Camera& camera, glm::dvec2 to_px);
    void go_freely(const Camera& camera, glm::dvec2 to_px);
    void go_along_uv(const Camera& camera, glm::dvec2 to_px);

    IncisedSkin skin_;
    IncisionSnaps snaps_;
    std::vector<SkinSample> hits_;
    glm::dvec2 begun_px_{0}, last_px_{0};
    std::size_t corner_ = 0; // from which the straight piece goes
    bool straight_ = false, moved_ = false;
    std::optional<IncisionSnap> at_end_;
    std::optional<SurfaceHit> on_wall_; // where the hand is, where that is over an open incision
    std::optional<std::array<IncisedSkin::SeenUvLine, 2>> uv_lines_; // once they are wanted
};

} // namespace trivar
