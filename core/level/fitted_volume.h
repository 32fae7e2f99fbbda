// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/tetrahedra_fit.h"
#include "core/level/voxel_field.h"
#include "core/simplex/field_fit.h"

namespace trivar {

// A FittedVolume is volume data as a sum of DMS basis functions: places are in voxels, values are
// samples, as those of a ScalarField. It is continuous but where the boundary was.
struct FittedVolume {
    SimplexField field;
    std::vector<bool> inside;     // by cell: whether the data are above the boundary there
    double boundary = 0;          // in samples
    std::size_t coefficients = 0; // unknowns of the fit
    std::size_t left_out = 0;     // samples between the boundary and the flat faces along it
    double rms = 0;               // of the differences at the others, in samples
};

// Fits the values of a field at the points of its grid; at every second, third .. along each axis
// if there were more than 100 for each coefficient otherwise. A sample on the other side of the
// boundary than its cell is left out. Cells are half as long at the boundary as elsewhere, and as
// short as the coefficients allow. Cost: 2 s for 2,000 of them, most of it the mesher's; the same
// bits for any number of threads. Throws Rejected as parted_cells() and fitted_field() do.
FittedVolume fitted_volume(const VoxelField& field, const TetrahedraFit& fit);

// Returns the closed surface of the body on one side of a level; see field_surface(). At the
// boundary's level it is the border of the cells inside or outside, where the fit itself may be
// beyond the level in small spots.
//   level     a value of the grid's data
//   to_space  maps voxels to the mesh's space
Mesh fitted_surface(const FittedVolume& volume, const VoxelGrid& grid, double level, LevelSide side,
                    const glm::dmat4& to_space);

} // namespace trivar
