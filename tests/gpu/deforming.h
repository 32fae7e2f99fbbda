// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/deform_timer.h"
#include "tests/ffd/samples.h"
#include "tests/gpu/support.h"

namespace trivar::gpu::testing {

inline Stage stage_of(const std::array<Knots, 3>& axes, double size,
                      const Embedding& embedding = {})
{
    return {make_ref(trivar::testing::random_lattice(axes, size)), embedding};
}

inline std::array<Knots, 3> equal_axes(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    return {knots, knots, knots};
}

// Expects two ways to agree as closely as they have to.
inline void expect_equal(const DeformedArrays& a, const DeformedArrays& b)
{
    ASSERT_EQ(a.positions.size(), b.positions.size());
    ASSERT_EQ(a.normals.size(), b.normals.size());
    ASSERT_EQ(a.tangents.size(), b.tangents.size());
    const DeformErrors off = errors_of(a, b);
    EXPECT_LT(off.position, 1e-6);
    EXPECT_LT(off.normal_deg, 0.05);
    EXPECT_LT(off.tangent_deg, 0.05);
    for (std::size_t i = 0; i < a.tangents.size(); ++i)
        ASSERT_EQ(a.tangents[i].w, b.tangents[i].w) << "tangent " << i;
}

inline DeformedArrays by_processor(const Mesh& mesh, const std::vector<Stage>& stages)
{
    Mesh out = mesh;
    for (const Stage& stage : stages) out = deform(out, stage.embedding, *stage.lattice);
    return {out.positions, out.normals, out.tangents};
}

class DeformedByTheDevice : public WithContext {
protected:
    DeviceDeformer deformer;
    BlindDraw draw;

    DeformedArrays by_device(const Mesh& mesh, const std::vector<Stage>& stages,
                             const Method& method = {})
    {
        const DeviceVertices from = uploaded_vertices(mesh);
        DeviceVertices to;
        deformer.deform(from, to, stages, method);
        return read_back(to);
    }

    // Deforms as the vertex shader does while it draws: the last volume there, the others before.
    DeformedArrays by_vertex_shader(const Mesh& mesh, const std::vector<Stage>& stages)
    {
        DeviceVertices from = uploaded_vertices(mesh), between;
        const std::span<const Stage> first(stages.data(), stages.size() - 1);
        if (!first.empty()) deformer.deform(from, between, first);
        const DeviceVertices& drawn = first.empty() ? from : between;
        deformer.bind(stages.back(), drawn.bounds, glm::dvec3(0));
        draw.take(drawn);
        const PackedAxes& axes = deformer.lattices().lattice(stages.back().lattice).axes->packed;
        return draw.captured(volume_defines(axes.order, deformer.reads_texels()));
    }
};

} // namespace trivar::gpu::testing
