// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

// A Tween says how a value goes from one key to the next: it stays until then, along a straight
// line, along a cubic Bezier curve in the plane of frames and values, or it settles: it swings past
// the next value and back, less each time, as something elastic that is let go.
enum class Tween { step, linear, cubic, settle };

// A Repeat decides the time after the last frame: nothing more, all of it again, or the way back.
enum class Repeat { once, loop, back_and_forth };
// The time inside of something that lasts from 0 to `length` and is repeated; length must be above
// 0.
double folded(Repeat repeat, double time, double length);

struct Key {
    double frame = 0, value = 0;
    Tween tween = Tween::cubic; // from here to the next key
    // The inner control points of the curve, [frames, value] relative to the key, toward the key
    // before and the key after. 0 frames: chosen so that the curve is smooth and goes beyond no
    // key.
    glm::dvec2 before{0}, after{0};
    bool operator==(const Key&) const = default;
};

// A Track says how one number changes in time.
struct Track {
    std::string parameter; // its name (core/document/parameters.h)
    std::vector<Key> keys; // ascending by frame, at most one per frame
    Repeat repeat = Repeat::once;
    bool operator==(const Track&) const = default;
};

// Tracks holds the tracks by the names of their parameters. Copies share them: an object that is
// copied because another of its members changes does not copy its keys.
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

// The value at any frame, whole or between two, without evaluating others. Before the first key it
// is that key's value, after the last one it follows `repeat`. Exact at keys. O(log #keys). The
// track must have at least one key.
double value_at(const Track& track, double frame);

// A TweenCurve is a cubic piece between two keys, with its inner control points moved so that no
// frame is met twice. Handles of 0 frames get a third of the way and the slope of Fritsch and
// Butland (SIAM J. Sci. Stat. Comput. 5(2), 1984): monotone where the keys are, level at turning
// points and ends.
struct TweenCurve {
    glm::dvec2 p0, p1, p2, p3; // frames, value
};
TweenCurve curve_between(const Track& track, std::size_t key); // between the key and the next one
// The same for any tween, as cubic pieces by ascending frames: two of a step, three of what settles
// (half periods of a damped oscillation, level at their ends), otherwise one.
std::vector<TweenCurve> curves_between(const Track& track, std::size_t key);

// The track with a key at a frame, which replaces a key in that frame; its tween is that of the key
// before.
Track with_key(Track track, double frame, double value);

} // namespace trivar
