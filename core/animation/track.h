// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

// How a value goes from one key to the next: it stays until then, along a straight line, or along
// a cubic Bezier curve in the plane of frames and values.
enum class Tween { step, linear, cubic };

// What comes after the last frame of something: nothing, all of it again, or the way back.
enum class Repeat { once, loop, back_and_forth };
// Where a time is in what lasts from 0 to a length, more than 0, and is repeated so.
double folded(Repeat repeat, double time, double length);

struct Key {
    double frame = 0, value = 0;
    Tween tween = Tween::cubic; // from here to the next key
    // Where the curve's inner control points are, [frames, value] from the key, toward the key
    // before and the one after. No frames: chosen so that the curve is smooth and goes beyond no
    // key.
    glm::dvec2 before{0}, after{0};
    bool operator==(const Key&) const = default;
};

// How one number changes in time.
struct Track {
    std::string parameter; // its name (core/document/parameters.h)
    std::vector<Key> keys; // ascending by frame, no two in one
    Repeat repeat = Repeat::once;
    bool operator==(const Track&) const = default;
};

// Tracks by name of their parameter. Copies share them: an object that is copied because something
// else of it changes does not copy its keys.
class Tracks {
public:
    Tracks() = default;
    Tracks(std::vector<Track> all) : all_(all.empty() ? nullptr : make_ref(std::move(all))) {}
    operator const std::vector<Track>&() const { return all(); }
    const std::vector<Track>& all() const
    {
        static const std::vector<Track> none;
        return all_ ? *all_ : none;
    }
    auto begin() const { return all().begin(); }
    auto end() const { return all().end(); }
    std::size_t size() const { return all().size(); }
    bool empty() const { return !all_; }
    const Track& operator[](std::size_t i) const { return all()[i]; }
    bool operator==(const Tracks& other) const
    {
        return all_ == other.all_ || all() == other.all();
    }

private:
    Ref<std::vector<Track>> all_; // null: none
};

// At any frame, whole or between two, directly: before the first key as there, after the last one
// by `repeat`. Exact at keys. O(log #keys). At least one key.
double value_at(const Track& track, double frame);

// A cubic piece between two keys: its control points, the inner ones moved so that no frame is met
// twice. Handles without frames have a third of the way and the slope of Fritsch and Butland (SIAM
// J. Sci. Stat. Comput. 5(2), 1984): monotone where the keys are, level at turning points and ends.
struct TweenCurve {
    glm::dvec2 p0, p1, p2, p3; // frames, value
};
TweenCurve curve_between(const Track& track, std::size_t key); // that one and the next

// The track with a key there, in place of one in that frame; its tween is that of the key before.
Track with_key(Track track, double frame, double value);

} // namespace trivar
