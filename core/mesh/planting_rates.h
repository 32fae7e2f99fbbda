// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/gait.h"
#include "core/mesh/pose_rates.h"

namespace trivar {

// How fast what planted() adds to the points of a leg changes, at most, between two moments of a
// clip with no break (breaks_of) between: a point p takes the share f of the displacement
//
//   f = (l + e . (p - o)) / L,    displacement = d / s,
//
// o and e being the joint above it and the direction to the next one, l and L the lengths of the
// leg down to o and in whole, and s the mean share of the sole (core/mesh/foot_lock.h). d goes
// evenly. Where a leg only turns, f is constant, and so is s. Else the product rule bounds both;
// e, l and p are seen from the joint, where all above it keeps lengths. Units of the model,
// seconds.
class PlantingRates {
public:
    // Of the gait's foot with that number. Nothing where it is not known: where a leg may have no
    // length, or the sole may or may not take the least share of it.
    static std::optional<PlantingRates> of(const Model& model, const Clip& clip, const Gait& gait,
                                           std::size_t foot, const std::vector<LocalRates>& local,
                                           double from_s, double to_s);

    // A vector's length and those of its derivatives, at most.
    struct Bound {
        double most = 0, first = 0, second = 0;
    };
    // Of what is added to the points of a node of that leg, these being so in the node's own space.
    Bound at(int node, const Bound& point) const;

private:
    struct Bone {
        std::vector<NodeRates> rates;     // as seen from `from`
        double scale = 1;                 // of what is seen to the model
        glm::dvec3 joint{0};              // at the middle moment
        NodeRates own;                    // of the joint
        Bound before, direction{1, 0, 0}; // the length above it; a unit vector
    };
    PlantingRates() = default;
    Bound share(int node, const Bound& point) const;

    const Model* model_ = nullptr;
    std::vector<int> leg_;
    std::vector<Bone> bones_;         // none: all take all of it
    std::vector<glm::dvec3> origins_; // of nodes, at the middle moment
    std::vector<double> sizes_;       // of their matrices, at most
    double half_s_ = 0, least_length_ = 0;
    Bound length_, more_;             // L, 1 / s
    double distance_ = 0, speed_ = 0; // of d
};

} // namespace trivar
