// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// What a travelling model does where its stroke ends: it stops there, is not shown any more, goes
// straight on, goes on from the other end, or turns back without turning round.
enum class Ends { stay, hide, run_on, loop, back_and_forth };

// How a placed model moves along the middle of its volume.
struct Travel {
    double speed = 0; // metres a second, the way it looks; negative: backwards; 0: it rests
    Ends ends = Ends::stay;
    double ease_in = 0, ease_out = 0; // seconds from rest to that speed, and to rest again
    int start_frame = 1;              // when it sets out
    double duration = 0;              // seconds after which it stops wherever it is; 0: it does not
    int followers = 0;                // as many more of it go behind, one after the other
    double gap = 0;   // metres along the middle from one to the next; 0: evenly along a loop, else
                      // as close as they are long
    double phase = 0; // of its clip's period, from one to the next
    bool operator==(const Travel&) const = default;
};

// The line v = 1/2 of a contact surface by its length in the world, as 1,024 chords; straight on
// beyond its ends.
class MiddleLine {
public:
    explicit MiddleLine(const Surface<glm::dvec3>& contact);
    double length() const { return length_.back(); } // metres
    double length_at(double u) const;                // from u = 0; negative before it
    double u_at(double length) const;
    bool closed() const { return closed_; } // it ends where it begins, and so do the rims
    double rounds_to_start() const { return rounds_to_start_; } // 2 on a twisted band
    glm::dvec2 slopes(double from, double to) const; // of u_at between two lengths: least, greatest

private:
    std::vector<double> length_;  // up to u = 0, 1/1024 .. 1
    double first_ = 0, last_ = 0; // metres by u at the ends
    bool closed_ = false;
    double rounds_to_start_ = 1;
};

// Where a model is at any time of its travel. The middle of the model goes along the middle line at
// constant speed in the world: the volume's parameter u is shifted by as much as that takes
// (parameter translation; Schein 2006, 2.4.3). Never the result of a step before.
class Journey {
public:
    Journey(const Travel& travel, const PlacementParameters& parameters,
            const Surface<glm::dvec3>& contact);

    struct Place {
        double shift_u = 0; // 0 until it sets out, exactly
        bool hidden = false;
        double gone_u = 0; // since it set out, every round and every return counted
        bool operator==(const Place&) const = default;
    };
    // Since it set out; the first of a procession, or one that follows. Where the stroke does not
    // reach back far enough, those that follow are not shown until they come to its start.
    Place at(double seconds, int follower = 0) const;
    // How far gone_u is at most, between two times, from going evenly from the one's to the
    // other's.
    double unevenness_u(double from_s, double to_s, int follower = 0) const;
    double seconds() const; // until it rests for good or is gone; infinity: never
    // The speed with which it would take that time; as it is where speed does not decide that.
    double speed_for(double seconds) const;
    const MiddleLine& line() const { return line_; }
    bool has_room() const { return has_room_; } // not the whole of an open stroke is filled
    bool rounds() const { return rounds_; }     // a closed stroke, where u may reach 1 + fill
    const Travel& travel() const { return travel_; }

private:
    // From rest to speed to rest: over a given way, or on and on.
    struct Run {
        double way = 0, speed = 0, in = 0, out = 0;
        double seconds() const;
        double covered(double seconds) const;
        glm::dvec2 speeds(double from_s, double to_s) const; // the least and the greatest between
    };
    static Run run_over(double way, double speed, double in, double out);
    Run limited(const Run& run) const;
    double turned_length(double seconds) const;
    double length_of_first(double seconds) const;
    glm::dvec2 speeds_of_first(double from_s, double to_s) const;
    double unrolled_u(double length) const; // every round and every return counted

    Travel travel_;
    MiddleLine line_;
    double fill_, middle_;       // of the model: of the stroke, and u at rest
    double from_, least_, most_; // lengths of its middle: at rest, and as far as the stroke lets it
    double direction_ = 1, gap_ = 0;
    bool has_room_ = false, rounds_ = false;
    Run run_, back_; // back_: every leg but the first, where it turns
};

} // namespace trivar
