// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/incised.h"
#include "core/incise/through.h"

#include <memory>

namespace trivar {

// A SlitLayout is where cuts lie: their lines on both sides of the skin, and the ways of their
// columns. It stays where it is made, as its parts know each other.
struct SlitLayout {
    explicit SlitLayout(const SlitSkin& skin) : drawing(skin) {}
    SlitLayout(const SlitLayout&) = delete;
    SlitLayout& operator=(const SlitLayout&) = delete;

    SlitDrawing drawing;
    std::vector<SlitRun> runs;
    std::optional<Inward> inward;
    std::optional<SlitColumns> columns;
    std::vector<ThroughSlit> throughs;
};

// Shortfalls say, by incision, why one that was to go through the body has a floor; empty: it goes
// through, or was not to.
using Shortfalls = std::vector<std::string>;

// Lays all incisions that can be drawn; the outcome of others says why not. Those with a shortfall
// have a floor. No layout: one more of them cannot go through, and its shortfall says why. `reach`
// and `rows` are those of the options of incise().
std::unique_ptr<SlitLayout> laid_out(const SlitSkin& skin, std::span<const Incision> incisions,
                                     double reach, int rows,
                                     std::vector<IncisedMesh::Outcome>& outcomes,
                                     Shortfalls& shortfalls);

} // namespace trivar
