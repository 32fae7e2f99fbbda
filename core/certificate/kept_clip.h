// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>
#include <optional>

namespace trivar {

// How the time of a clip goes while a film is played, piece after piece, each evenly.
struct PlayedTime {
    struct Piece {
        double from_s, to_s;           // since the film began; each from where the last one ends
        double clip_from_s, clip_to_s; // of the clip
    };
    std::vector<Piece> pieces; // at least one
    // They go from one moment to the next, and nothing of the clip between is looked at: where the
    // place in the clip has keys, or a lap is shorter than that.
    bool by_moments = false;
    // The tenth or sixteenth of a frame that is as near to a time as single precision tells them
    // apart, and where the clip is then; nothing: there is none. A jump is put to the side of it on
    // which it is seen.
    struct SeenTime {
        double film_s, clip_s;
    };
    std::function<std::optional<SeenTime>(double film_s)> seen;
};

// Of an object that plays the clip and lies in no volume, between the first and the last of some
// moments, in frames.
PlayedTime played_time(const Document& document, Id object, const Clip& clip,
                       const std::vector<double>& moments);

// A channel of the clip as the film shows it: keys where it has keys, and where the film begins and
// ends, and the clip begins anew or turns back; between two it goes as it did. The same function of
// time, but for single precision. A part of a cubic rotation that is cut between two of its keys is
// no such curve; it gets as many as make up for that.
Channel played(const Channel& channel, const PlayedTime& time);

} // namespace trivar
