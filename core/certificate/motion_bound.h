// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/certificate/keyed_volume.h"
#include "core/certificate/reached_volumes.h"
#include "core/certificate/volume_bends.h"

#include <optional>

namespace trivar {

// What is proven of one object from one moment to the next: how far a point of it, on the true
// surface, is at any time between them from the straight way between where it is at the two.
//
//   |F(q(t)) - chord|  <=  sum_a |F_a| dev_a  +  1/8 sum_ab |F_ab| d_a d_b  +  1/4 sum_a kink_a d_a
//
// q(t) is the point in the volume's parameters, d its step from one moment to the other, and dev
// how far q(t) is from going evenly: by travel (Journey::unevenness_u), and by the clip's pose
// between the moments at which it has keys (core/certificate/clip_deviation.h). What keys make of
// the volume itself comes to it (KeyedVolume).
class MotionBound {
public:
    MotionBound(const Document& document, Id object, const AssetStore& assets);

    // Why nothing is proven of it, a sentence's end; empty: something is.
    const std::string& unknown() const { return unknown_; }
    // Metres; infinite where it is not bounded, as where it jumps. The evaluated objects and their
    // parts of one key, at two frames with whole ones not between.
    double operator()(const EvaluatedObject& from, const Part& a, double from_frame,
                      const EvaluatedObject& to, const Part& b, double to_frame);
    // No triangle of a part with such edges, in the object, is further from the true surface at
    // that moment; infinite where that does not say.
    double space(const Part& part, const std::vector<glm::vec3>& before_volume,
                 const std::vector<glm::uvec3>& triangles);
    // By how much a step in the object is longer in the world, at most.
    double stretch(const Part& part);

private:
    VolumeBends& bends(const Ref<Lattice>& volume);

    std::string unknown_;
    Object object_;
    std::optional<KeyedVolume> keyed_;
    Ref<Model> model_;       // null: it is none of a file
    std::vector<int> nodes_; // that have a mesh, by PartKey::mesh
    double frames_per_second_ = 24;
    ReachedVolumes volumes_;
    std::map<Ref<Lattice>, std::unique_ptr<VolumeBends>> bends_;
};

// Why an object in a volume moves in a way that is known at single moments only; empty: it does
// not. Travel and clips are known at all times, keys and what lies on moving things are not.
std::string why_unproven(const Document& document, Id object);

} // namespace trivar
