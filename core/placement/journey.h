// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement_input.h"
#include "core/spline/surface.h"

namespace trivar {

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
    // Returns the least and the greatest slope of u_at between two lengths.
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
