// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// What a travelling model does where its stroke ends: stops there, disappears, continues straight,
// continues from the other end, or goes back without turning round.
// straight on, goes on from the other end, or turns back without turning round.
enum class Ends { stay, hide, run_on, loop, back_and_forth };

// A Travel says how a placed model moves along the middle of its volume.
struct Travel {
    // metres per second in the direction it looks; negative: backwards; 0: it rests
    double speed = 0;
    Ends ends = Ends::stay;
    double ease_in = 0, ease_out = 0; // seconds from rest to that speed, and back to rest
    int start_frame = 1;              // when it sets out
    double duration = 0;              // seconds after which it stops wherever it is; 0: no limit
    int followers = 0;                // number of further copies that follow one after the other
    double gap = 0;   // metres along the middle from one to the next; 0: evenly along a loop, else
                      // as close as they are long
    double phase = 0; // shift from one follower to the next, as a share of the clip's period
    bool operator==(const Travel&) const = default;
};

// A MiddleLine is the line v = 1/2 of a contact surface by its length in the world, as 1,024
// chords; it continues straight beyond its ends.
class MiddleLine {
public:
    explicit MiddleLine(const Surface<glm::dvec3>& contact);
    double length() const { return length_.back(); } // metres
    double length_at(double u) const;                // from u = 0; negative before that
    double u_at(double length) const;
    bool closed() const { return closed_; } // the line ends where it begins, and so do the rims
    double rounds_to_start() const { return rounds_to_start_; } // 2 on a twisted band
    // of u_at between two lengths: least and greatest
    glm::dvec2 slopes(double from, double to) const;

private:
    std::vector<double> length_;  // up to u = 0, 1/1024 .. 1
    double first_ = 0, last_ = 0; // metres per unit of u at both ends
    bool closed_ = false;
    double rounds_to_start_ = 1;
};

// A Journey tells where a model is at any time of its travel. The middle of the model moves along
// the middle line at constant speed in the world: the volume's parameter u is shifted accordingly
// (parameter translation; Schein 2006, 2.4.3). No result depends on an earlier one.
class Journey {
public:
    Journey(const Travel& travel, const PlacementParameters& parameters,
            const Surface<glm::dvec3>& contact);

    struct Place {
        double shift_u = 0; // exactly 0 until it sets out
        bool hidden = false;
        double gone_u = 0; // since it set out, with every round and every return counted
        bool operator==(const Place&) const = default;
    };
    // The place of the first model, or of a follower, at a time since setting out. Where the stroke
    // does not reach back far enough, followers are hidden until they come to its start.
    Place at(double seconds, int follower = 0) const;
    // The largest distance of gone_u, at any time between two times, from the straight line between
    // its values at both.
    double unevenness_u(double from_s, double to_s, int follower = 0) const;
    double seconds() const; // until it rests for good or is gone; infinity: never
    // The speed at which the travel would take that time; the present speed where speed does not
    // decide it.
    double speed_for(double seconds) const;
    const MiddleLine& line() const { return line_; }
    bool has_room() const { return has_room_; } // an open stroke is not filled completely
    bool rounds() const { return rounds_; } // the stroke is closed, so that u may reach 1 + fill
    const Travel& travel() const { return travel_; }

private:
    // A Run goes from rest to speed to rest, over a given way or without end.
    struct Run {
        double way = 0, speed = 0, in = 0, out = 0;
        double seconds() const;
        double covered(double seconds) const;
        // the least and the greatest between both times
        glm::dvec2 speeds(double from_s, double to_s) const;
    };
    static Run run_over(double way, double speed, double in, double out);
    Run limited(const Run& run) const;
    double turned_length(double seconds) const;
    double length_of_first(double seconds) const;
    glm::dvec2 speeds_of_first(double from_s, double to_s) const;
    double unrolled_u(double length) const; // with every round and every return counted

    Travel travel_;
    MiddleLine line_;
    double fill_, middle_; // of the model: its share of the stroke, and u at rest
    // lengths of the model's middle: at rest, and the range that the stroke allows
    double from_, least_, most_;
    double direction_ = 1, gap_ = 0;
    bool has_room_ = false, rounds_ = false;
    Run run_, back_; // back_: every leg but the first, where the model goes back
};

} // namespace trivar
