// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/voxels/read_volume.h"

#include <gtest/gtest.h>
#include <string>

namespace trivar::testing {

// The sentence with which bytes are refused; empty where they are read.
inline std::string refusal(std::string_view bytes, const std::string& name,
                           const ReadVolumeOptions& options = {}, const std::string& folder = "")
{
    try {
        read_volume_bytes(bytes, name, folder, options);
    } catch (const Rejected& rejected) {
        return rejected.what();
    }
    return {};
}

// Expects two matrices to differ by at most 1e-9 m.
inline void expect_same_place(const glm::dmat4& a, const glm::dmat4& b, double tolerance = 1e-9)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(a[column][row], b[column][row], tolerance) << column << ' ' << row;
}

// A matrix in metres of an upright grid in millimetres.
inline glm::dmat4 upright_mm(const glm::dvec3& spacing, const glm::dvec3& origin)
{
    glm::dmat4 out(1);
    for (int k = 0; k < 3; ++k) {
        out[k][k] = spacing[k] * 1e-3;
        out[3][k] = origin[k] * 1e-3;
    }
    return out;
}

} // namespace trivar::testing
