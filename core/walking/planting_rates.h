// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walking/gait.h"
#include "core/walking/pose_rates.h"

namespace trivar {

// PlantingRates bounds how fast the movement changes that planted() adds to the points of a leg,
// between two moments of a clip with no break (breaks_of) between them. A point p takes the share f
// of the displacement:
//
//   f = (l + e . (p - o)) / L,    displacement = d / s,
//
// o and e are the joint above the point and the direction to the next joint, l and L the lengths of
// the leg down to o and of the whole leg, and s the mean share of the sole, or 1
// (core/walking/foot_lock.h). d moves evenly. A point that keeps its place beside a joint of a leg
// that only turns takes the same share at all times. Otherwise the product rule bounds it; e, l and
// p are seen from the joint, where all nodes above it keep lengths. Units of the model, seconds.
class PlantingRates {
public:
    // The rates for the foot with that number in the gait. Empty where they are not known: where a
    // bone of the leg may come to length 0, or where the sole's share may be above or below the
    // least one.
    static std::optional<PlantingRates> of(const Model& model, const Clip& clip, const Gait& gait,
                                           std::size_t foot, const std::vector<LocalRates>& local,
                                           double from_s, double to_s);

    // Returns the rates of the additions to the points of a node; `point` gives a point's rates in
    // the node's own space.
    Rates at(int node, const Rates& point) const;

private:
    struct Bone {
        std::vector<NodeRates> rates; // as seen from the joint, or from the model
        double scale = 1;             // of what is seen to the model
        glm::dvec3 joint{0};          // at the middle moment
        NodeRates own;                // of the joint
        Rates way;                    // to the next joint, at the middle moment
        Rates above, direction;       // l and e
    };
    PlantingRates() = default;
    bool add_bones(const Model& model, const Foot& foot, const Stance& middle,
                   const std::vector<LocalRates>& local);
    bool add_sole(const Model& model, const Clip& clip, const Foot& foot, const Stance& middle,
                  double middle_s);
    Rates share(int node, const Rates& point) const;

    std::vector<int> bone_of_node_;
    std::vector<Bone> bones_;         // empty: every point takes the whole displacement
    std::vector<glm::dvec3> origins_; // of nodes, at the middle moment
    std::vector<double> sizes_;       // of their matrices, at most
    double half_s_ = 0;
    Rates inverse_length_, inverse_share_{1, 0, 0}; // 1 / L, 1 / s
    Rates displacement_;                            // d
};

} // namespace trivar
