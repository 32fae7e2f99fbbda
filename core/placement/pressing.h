// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/ref.h"
#include "core/ffd/guard.h"
#include "core/placement/shaping.h"

namespace trivar {

// A LaidVolume is a volume with its state when it was laid, over the same knots.
struct LaidVolume {
    Ref<Lattice> volume, as_laid;
    double ground = 0;                     // w of the surface that lies on the scene
    std::vector<VolumePart> may_fold = {}; // not judged
    Lazy<CellVerdicts> verdicts = {};
    GuardOptions guard() const;
};
LaidVolume laid_volume(Lattice volume, double ground);
// The same LaidVolume with another volume over its knots, of which verdicts may be known already.
LaidVolume with_volume(LaidVolume laid, Lattice volume, std::optional<CellVerdicts> verdicts = {});

// The same LaidVolume, which may fold inside the given boxes.
LaidVolume allowing_folds(LaidVolume laid, std::vector<VolumePart> boxes);

// Whether a ball at that place touches the surface on the scene, so that it moves whole columns.
bool at_scene(const Lattice& volume, double ground, const glm::dvec3& uvw);

// A Pressing is a press in progress, from one sample to the next. Control points move along their
// columns, toward the surface that lies on the scene; where the ball is at that surface itself, it
// lifts or drops whole columns instead, which keep their height. All distances are those of the
// volume at the beginning.
class Pressing {
public:
    Pressing(const LaidVolume& begun, const Press& press);

    // The moves of control points for one more sample, before anything is proven. Columns stay on
    // the scene unless they may go into it. Where guarded, no point comes nearer to the next one of
    // its column than 2 % of their distance as laid. O(#control points).
    std::vector<PointMove> moves(const glm::dvec4& sample) const;
    // BallMotion says how far the ball went, between 0 and the sample's amount, as far as any
    // control point could follow it, and whether the guard stopped it.
    struct BallMotion {
        double metres = 0;
        bool would_fold = false;
    };
    // Moves the control points; where guarded, only as far as that is proven not to fold.
    BallMotion add(const glm::dvec4& sample);

    double farthest() const; // the longest way of any control point, metres
    const Lattice& volume() const { return volume_; }
    // The verdicts on the present volume; empty where the press is not guarded.
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
    CellVerdicts verdicts_; // of the present volume, where guarded
    GuardOptions guard_;
    Press press_;
    double ground_;
    Lattice start_;
    std::vector<glm::dvec3> points_; // of start_, world
    std::vector<glm::dvec3> up_;     // of each column, unit; n_u x n_v, v fastest
    // Returns the height of a point of the present volume along `up`.
    double height(std::size_t point, const glm::dvec3& up) const;

    std::vector<double> toward_scene_;   // of each layer: -1, 1, or 0 on the scene
    std::vector<double> gap_, on_scene_; // least |P_k - P_k-1|; height of the scene along up_
};

// Throws Rejected, naming the field, for values that are impossible.
void check(const Press& press);

} // namespace trivar
