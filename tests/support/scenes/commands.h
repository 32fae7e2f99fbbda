// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/evaluation/evaluate.h"

#include <random>

namespace trivar::testing {

// A box 1, a sphere 2, a teapot 3 lying on both, a group 4 with the box, a kept view "front".
Document small_document();

// With an imported model 5 as well.
Document fitting_document();

// A short stroke over the ball of small_document().
TileStroke a_tile_stroke();
NamedIncision an_incision(); // over the ball

// Returns for every verb one command that fitting_document() accepts.
std::vector<Command> fitting_commands();

// A command whose fields are random: mostly sensible, now and then extreme, NaN or no text.
Command random_command(std::mt19937& random);

Sketch small_sketch();

inline Evaluator new_evaluator()
{
    return Evaluator(std::make_shared<const AssetStore>("."));
}

} // namespace trivar::testing
