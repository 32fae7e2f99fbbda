// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/animation/track.h"
#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/document/object_map.h"
#include "core/document/render_settings.h"
#include "core/document/source.h"
#include "core/placement/placement.h"
#include "core/placement/shaping.h"
#include "core/placement/travel.h"
#include "core/refinement/methods.h"

#include <map>
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

// The frames of a scene. Which of them is the present one is no part of it.
struct Time {
    int first_frame = 1, last_frame = 240;
    double frames_per_second = 24;
    bool operator==(const Time&) const = default;
};

// All causes, no effects. Copies share what they have in common.
struct Document {
    ObjectMap objects;
    Id next_id = 1;
    std::map<std::string, Camera> bookmarks;
    Ref<RenderSettings> render = make_ref(RenderSettings{});
    Time time = {};
    Ref<std::vector<Track>> tracks = make_ref(std::vector<Track>{}); // of its own numbers
    // The order of the outliner's rows where it was arranged; the others follow by id.
    Ref<std::vector<Id>> rows = make_ref(std::vector<Id>{});
    // Whether nothing of one was made anew in the other: what they have in common is the same, not
    // just equal. O(number of objects).
    bool operator==(const Document&) const = default;
};

// The object, or Rejected naming the id.
const Object& object(const Document& document, Id id);
bool is_lattice(const Document& document, Id id); // false also where there is no such object
// "object 3 (Snake)", for a sentence; a long name is cut.
std::string named(Id id, const Object& object);
std::string named(const Document& document, Id id);
bool visible(const Document& document, Id id); // neither it nor a parent is hidden
bool locked(const Document& document, Id id);  // it or a parent is
// Ids of the lattices that an object stands in, the innermost first.
std::vector<Id> lattices_round(const Document& document, Id id);
// All objects in the order of the outliner's rows, whatever is in which group.
std::vector<Id> in_row_order(const Document& document);
// The object's transform under its parents'. What is placed lies in the world without it.
glm::dmat4 to_world(const Document& document, Id id);
// Digest of the causes, 32 hexadecimal digits.
std::string digest(const Document& document);

} // namespace trivar
