// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/animation/track.h"
#include "core/base/ref.h"
#include "core/document/source.h"
#include "core/placement/placement.h"
#include "core/placement/shaping.h"
#include "core/placement/travel.h"
#include "core/refinement/methods.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

using Id = int; // of an object, from 1 up; never used twice in one document. 0: none

struct Transform {
    glm::dvec3 translation{0};
    glm::dvec3 rotation_deg{0}; // about X, then Y, then Z
    glm::dvec3 scale{1};
    glm::dmat4 matrix() const;
    bool operator==(const Transform&) const = default;
};

struct Surfacing { // one material over the whole object, in place of its own
    glm::vec4 base_color{0.8f, 0.8f, 0.8f, 1};
    float metallic = 0, roughness = 0.6f;
    Filling filling = Filling::none;
    bool operator==(const Surfacing&) const = default;
};

// The way of a volume round a cylinder, a sphere, a torus or a Moebius band.
struct RoundWay {
    double level = 0; // metres from its widest circle
    bool operator==(const RoundWay&) const = default;
};

// A stroke laid over other objects. `onto` is what the rays see: a dependency, so moving one of
// them places this one again. Cycles are refused.
struct PlacementStep {
    Sketch sketch;
    PlacementParameters parameters;
    std::vector<Id> onto;
    std::optional<RoundWay> round = {}; // about the only one of `onto`, in place of the stroke
    bool operator==(const PlacementStep&) const = default;
};

// How an object moves by a clip of its model (core/mesh/clip.h), whatever else moves it.
struct Playing {
    std::string clip = {}; // by its name; empty: it stands as it came
    double speed = 1;      // of the clip's own; negative: backwards
    Repeat repeat = Repeat::loop;
    double offset = 0;      // seconds into the clip at the start frame
    int start_frame = 1;    // from which on it moves
    bool foot_lock = false; // its travel says how far it goes on, not its speed
    bool operator==(const Playing&) const = default;
};

// Into triangles so fine that, deformed, they are within a tolerance of the true surface.
struct Refining {
    double tolerance = 1e-3; // metres
    SplitPoint split = SplitPoint::equidistributed;
    RefinementRule rule = RefinementRule::edge_driven;
    BoundMethod method = BoundMethod::composed_net;
    int budget = 1000000; // triangles
    bool operator==(const Refining&) const = default;
};

// With fewer triangles (core/simplify), before anything else is done with its shape.
struct Simplifying {
    double keep = 0.5;    // share of its triangles, above 0 and at most 1
    double deviation = 0; // metres, before it is placed or scaled, that no triangle is moved
                          // beyond; 0: as far as it takes
    bool operator==(const Simplifying&) const = default;
};

struct Object {
    std::string name;
    Source source;
    Transform transform;
    std::optional<Surfacing> surfacing;
    Id parent = 0;
    bool hidden = false;
    bool locked = false; // no hand takes it by accident; a command that names it may
    std::optional<PlacementStep>
        placement; // a placed object's translation waits; its rotation and scale turn it first
    // What was done to its volume after it was laid, one step after another.
    std::vector<Ref<VolumeEdit>> shaping = {};
    Travel travel = {};                    // along its stroke, if it lies on one
    Playing playing = {};                  // if it is an imported file
    std::optional<Refining> refining = {}; // if it lies on a stroke
    std::optional<Simplifying> simplifying = {};
    Tracks tracks = {}; // of what changes in time, by parameter
    bool operator==(const Object&) const = default;
};

} // namespace trivar
