// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>
#include <optional>

namespace trivar {

// PlayedTime says how the time of a clip runs while a film is played: in pieces, each at an even
// speed.
struct PlayedTime {
    struct Piece {
        double from_s, to_s; // since the film began; each piece begins where the last one ends
        double clip_from_s, clip_to_s; // time of the clip
    };
    std::vector<Piece> pieces; // at least one
    // Whether the pieces go from one moment to the next, so that the clip between two moments is
    // not looked at. This is so where the place in the clip has keys, or where a lap is shorter
    // than the step of the moments.
    bool by_moments = false;
    // The tenth or sixteenth of a frame that is nearest to a time and that single precision can
    // tell apart, with the time of the clip there; empty: there is none. A jump is put to the side
    // of that time on which it is seen.
    struct SeenTime {
        double film_s, clip_s;
    };
    std::function<std::optional<SeenTime>(double film_s)> seen;
};

// The object plays the clip and lies in no volume. `moments` are in frames; the result runs from
// the first to the last of them.
PlayedTime played_time(const Document& document, Id object, const Clip& clip,
                       const std::vector<double>& moments);

// The clip's channel as the film shows it. It has a key where the clip has one, where the film
// begins and ends, and where the clip begins anew or turns back; between two keys it runs as the
// clip does. It is the same function of time but for single precision. A piece of a cubic rotation
// that is cut between two keys is not a cubic curve of rotations; such a piece gets as many keys as
// it needs.
Channel played(const Channel& channel, const PlayedTime& time);

} // namespace trivar
