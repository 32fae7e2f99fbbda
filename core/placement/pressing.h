// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/ref.h"
#include "core/ffd/guard.h"
#include "core/placement/shaping.h"

namespace trivar {

// A volume and what it was when it was laid, over the same knots.
struct LaidVolume {
    Ref<Lattice> volume, as_laid;
    double ground = 0;                     // w of what lies on the scene
    std::vector<VolumePart> may_fold = {}; // not judged
    Lazy<CellVerdicts> verdicts = {};
    GuardOptions guard() const;
};
LaidVolume laid_volume(Lattice volume, double ground);
// The same with another volume over those knots, of which something is known already.
LaidVolume with_volume(LaidVolume laid, Lattice volume, std::optional<CellVerdicts> verdicts = {});

// The same volume, which may fold in those boxes.
LaidVolume allowing_folds(LaidVolume laid, std::vector<VolumePart> boxes);

// Whether a ball there is at what lies on the scene, and moves whole columns.
bool at_scene(const Lattice& volume, double ground, const glm::dvec3& uvw);

// A press as it goes on, from one sample to the next. Control points move along their columns,
// toward what lies on the scene; where the ball is at that itself, it lifts or drops whole columns
// instead, which keep their height. All distances are those of the volume it began with.
class Pressing {
public:
    Pressing(const LaidVolume& begun, const Press& press);

    // Where control points would go by one more sample, before anything is proven. Columns stay on
    // the scene unless they may go into it; where guarded, no point comes nearer to the next one of
    // its column than 2 % of their distance as laid. O(control points).
    std::vector<PointMove> moves(const glm::dvec4& sample) const;
    // How far the ball came, between 0 and the sample's amount, as far as any control point could
    // follow it; and whether it was kept from folding the volume.
    struct BallMotion {
        double metres = 0;
        bool would_fold = false;
    };
    // Moves them, where guarded as far as that is proven not to fold.
    BallMotion add(const glm::dvec4& sample);

    double farthest() const; // that any control point went, metres
    const Lattice& volume() const { return volume_; }
    // What is known of it; nothing where the press is not guarded.
    std::optional<CellVerdicts> verdicts() const
    {
        return press_.guard ? std::optional(verdicts_) : std::nullopt;
    }

private:
    std::vector<double> weights(const glm::dvec4& sample) const;
    std::vector<PointMove> moves(const glm::dvec4& sample, const std::vector<double>& w) const;
    std::vector<PointMove> on_layers(const std::vector<double>& weights, double amount) const;
    std::vector<PointMove> on_columns(const std::vector<double>& weights, double amount) const;

    Lattice volume_;
    CellVerdicts verdicts_; // of that, where guarded
    GuardOptions guard_;
    Press press_;
    double ground_;
    Lattice start_;
    std::vector<glm::dvec3> points_; // of start_, world
    std::vector<glm::dvec3> up_;     // of each column, unit; n_u x n_v, v fastest
    double height(std::size_t point, const glm::dvec3& up) const; // as it is now, along that

    std::vector<double> toward_scene_;   // of each layer: -1, 1, or 0 on the scene
    std::vector<double> gap_, on_scene_; // least |P_k - P_k-1|; height of the scene along up_
};

// Throws Rejected, naming the field, for what cannot be.
void check(const Press& press);

} // namespace trivar
