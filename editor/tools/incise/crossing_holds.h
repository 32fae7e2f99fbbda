// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "editor/tools/incise/cut_crossings.h"
#include "editor/tools/incise/incision_holds.h"

namespace trivar {

// A handle where the chosen incision crosses another one: of the crossing itself, which slides
// along the chosen one and takes the other one with it, or of one of the flaps between both.
struct CrossingHold {
    CutCrossing crossing;
    std::optional<PeeledFlap> flap; // as it is; none: it is that of the crossing
    glm::dvec2 p_px{0}, base_px{0}; // of the picture; base: the tip of the flap
    glm::dvec2 way_px{0, -1};       // along which a flap is pulled, unit
    double metres_per_px = 0;       // on the model, of its lift
    double highest = 0;             // metres on the model: about the length of the flap
};

// SeenIncising is the visible part of an object's incisions, by number; nothing of those that are
// hidden.
struct SeenIncising {
    const Incising& incising;
    const std::vector<std::optional<SeenCut>>& cuts;
    const std::vector<CutCrossing>& crossings;
};
// The handles at the crossings of incision `number`; of flaps, those at the crossing that is
// nearest to a pixel, where it is near.
std::vector<CrossingHold> crossing_holds(const SeenIncising& seen, int number, const Camera& camera,
                                         glm::dvec2 near_px, double scale);
// Returns which of them is under a pixel; nothing: none is.
std::optional<std::size_t> crossing_hold_at(const std::vector<CrossingHold>& holds, glm::dvec2 p_px,
                                            double scale);

// A drag of one, with all as it was when it began.
struct CrossingDrag {
    Id object = 0;
    int number = 1;      // of the chosen incision
    NamedIncision other; // which crosses it
    SeenCut seen, seen_other;
    IncisedSkin skin;
    CrossingHold held;
    Camera camera;
    glm::dvec2 from_px{0};
    double scale = 1; // of the interface
};
// The command for a hand at `to_px`; with `snap` in round steps. Pure.
Command dragged(const CrossingDrag& drag, glm::dvec2 to_px, bool snap);
// Returns the command for a typed number, in the unit that words_of() shows: percent of the chosen
// incision, or metres in the world.
Command typed_in(const CrossingDrag& drag, double number);

// "Crosses at 40 %, Incision 2 below", "Peeled 0.02 m", with the lift or place as it is.
std::string words_of(const CrossingHold& hold, const Incising& incising, const SeenCut& seen,
                     int number);

} // namespace trivar
