// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_net.h"

namespace trivar {

// A ChartSurface is a surface in space over the square charts of a net. Charts that share an edge
// agree there but for rounding; the normals do too, except on a crease.
class ChartSurface {
public:
    ChartSurface() = default;
    ChartSurface(const ChartSurface&) = default;
    ChartSurface& operator=(const ChartSurface&) = default;
    virtual ~ChartSurface() = default;
    virtual const ChartNet& net() const = 0;
    virtual glm::dvec3 position(const ChartPlace& at) const = 0;
    virtual glm::dvec3 normal(const ChartPlace& at) const = 0; // unit
};

} // namespace trivar
