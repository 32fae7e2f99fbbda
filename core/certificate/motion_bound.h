// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"
#include "core/certificate/keyed_volume.h"
#include "core/certificate/reached_volumes.h"
#include "core/certificate/volume_bends.h"

#include <optional>

namespace trivar {

// A MotionBound proves how far the motion of one object between two moments is from even motion:
// the largest distance, at any time between them, of a point of the true surface from the straight
// line between its places at both moments.
//
//   |F(q(t)) - chord|  <=  sum_a |F_a| dev_a  +  1/8 sum_ab |F_ab| d_a d_b  +  1/4 sum_a kink_a d_a
//
// q(t) is the point in the volume's parameters, d its step from one moment to the other, and dev
// the distance of q(t) from even motion: by travel (Journey::unevenness_u), and by the clip's pose
// between the moments at which it has keys (core/certificate/clip_deviation.h). The effect of keys
// on the volume itself is added (KeyedVolume).
class MotionBound {
public:
    MotionBound(const Document& document, Id object, const AssetStore& assets);

    // The end of a sentence that says why nothing is proven; empty: something is.
    const std::string& unknown() const { return unknown_; }
    // The bound in metres; infinite where there is none, for example where the object jumps. `a`
    // and `b` are parts of one key in the evaluated objects, at two frames with no whole frame
    // between them.
    double operator()(const EvaluatedObject& from, const Part& a, double from_frame,
                      const EvaluatedObject& to, const Part& b, double to_frame);
    // The largest distance, in the object, of a triangle of the part from the true surface at that
    // moment; infinite where the volume's bends give no bound.
    double space(const Part& part, const std::vector<glm::vec3>& before_volume,
                 const std::vector<glm::uvec3>& triangles);
    // The largest factor by which a step in the object is longer in the world.
    double stretch(const Part& part);

private:
    VolumeBends& bends(const Ref<Lattice>& volume);

    std::string unknown_;
    Object object_;
    std::optional<KeyedVolume> keyed_;
    Ref<Model> model_;       // null: the object has no model from a file
    std::vector<int> nodes_; // the nodes that have a mesh, by PartKey::mesh
    double frames_per_second_ = 24;
    ReachedVolumes volumes_;
    std::map<Ref<Lattice>, std::unique_ptr<VolumeBends>> bends_;
};

// Returns why the motion of an object in a volume is known at single moments only; empty: it is
// known at all times. Travel and clips are known at all times; keys and a stroke on moving objects
// are not.
std::string why_unproven(const Document& document, Id object);

} // namespace trivar
