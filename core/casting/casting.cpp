// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/casting.h"

namespace trivar {

Casting casting_of(const Ref<VoxelField>& field, std::span<const TransferPoint> points,
                   double least, double greatest)
{
    const VoxelGrid& grid = field->grid();
    const double range = greatest > least ? greatest - least : 1;
    const glm::dvec2 share(grid.slope / range, (grid.intercept - least) / range);
    TransferTable transfer = transfer_table(points, least, least + range);
    EmptyBricks empty = empty_bricks(field->hulls(), transfer, share);
    OpenBricks open = open_bricks(field->field(), empty, transfer, share);
    return {field, std::move(transfer), std::move(empty), std::move(open), share};
}

} // namespace trivar
