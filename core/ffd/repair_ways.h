// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/repair_options.h"

namespace trivar {

// A RepairSite holds what the ways of a repair share: which control points reach a cell, and which
// must stay.
class RepairSite {
public:
    RepairSite(const Lattice& lattice, const RepairOptions& options);

    const CellGrid& grid() const { return grid_; }
    const RepairOptions& options() const { return options_; }
    bool held(std::size_t point, bool ground_yields) const;
    glm::ivec3 index(std::size_t point) const;
    // height of the tallest column of the given lattice, world
    double tallest() const { return tallest_; }

    // The stored points of a cell's basis functions, w fastest.
    std::vector<std::size_t> points_of(const Trivariate<glm::dvec3>& f, int cell) const;
    // The columns that reach cells which are not good, by their indices on the ground, ascending.
    std::vector<glm::ivec3> columns(const Trivariate<glm::dvec3>& f,
                                    const CellVerdicts& verdicts) const;

private:
    RepairOptions options_;
    CellGrid grid_;
    glm::ivec3 count_;
    std::vector<bool> held_;
    double tallest_ = 0;
};

std::vector<int> doubtful_cells(const CellVerdicts& verdicts);

// These functions do one pass of each way: moves that improve the cells which are not good. Empty:
// the way gives up.
std::vector<PointMove> smoothed_directions(const RepairSite& site, const Lattice& lattice,
                                           const CellVerdicts& verdicts);
// Columns are kept under a cap that falls with every pass.
std::vector<PointMove> lowered_heights(const RepairSite& site, const Lattice& lattice,
                                       const CellVerdicts& verdicts, int pass);
// The gap between layers doubles with every pass.
std::vector<PointMove> monotone_columns(const RepairSite& site, const Lattice& lattice,
                                        const CellVerdicts& verdicts, int pass);
std::vector<PointMove> evened(const RepairSite& site, const Lattice& lattice,
                              const CellVerdicts& verdicts, bool ground_yields);
// Raises det J at samples of the given cells, which are or once were not good, to slightly above
// zero. Each sample is met by the least-squares moves along its gradient, which for control point a
// is cof(J) grad N_a. Cells that were mended before stay among them, so that mending their
// neighbours does not undo them.
std::vector<PointMove> relaxed(const RepairSite& site, const Lattice& lattice,
                               const CellVerdicts& verdicts, std::span<const int> cells, int pass,
                               bool ground_yields);

} // namespace trivar
