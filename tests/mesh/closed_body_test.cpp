// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

Mesh both(const Mesh& a, const Mesh& b)
{
    Mesh out = a;
    out.points.clear();
    out.positions.insert(out.positions.end(), b.positions.begin(), b.positions.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::vector<std::uint32_t> face(b.corners.begin() + b.face_begin[f],
                                        b.corners.begin() + b.face_begin[f + 1]);
        for (std::uint32_t& v : face) v += static_cast<std::uint32_t>(a.vertex_count());
        add_face(out, face);
    }
    out.points = points_by_position(out.positions);
    return out;
}

Mesh box_at(double x)
{
    Mesh box = transformed(box_mesh({1, 1, 1}, {2, 2, 2}), {{1, 0, 0, 0}, //
                                                            {0, 1, 0, 0},
                                                            {0, 0, 1, 0},
                                                            {x, 0, 0, 1}});
    box.points = points_by_position(box.positions);
    return box;
}

Mesh inside_out(Mesh mesh)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        std::reverse(mesh.corners.begin() + mesh.face_begin[f],
                     mesh.corners.begin() + mesh.face_begin[f + 1]);
    return mesh;
}

} // namespace

TEST(ClosedBody, IsWhatIsClosedAndLooksOutwards)
{
    EXPECT_TRUE(is_closed_body(box_at(0)));
    EXPECT_TRUE(is_closed_body(box_at(1e4))); // wherever it lies
    EXPECT_FALSE(is_closed_body(inside_out(box_at(0))));
    EXPECT_FALSE(is_closed_body(Mesh{}));
}

TEST(ClosedBody, NoMeshWithAHoleIs)
{
    Mesh open = box_at(0);
    open.corners.resize(open.face_begin[open.face_count() - 1]);
    open.face_begin.pop_back();
    EXPECT_FALSE(is_closed_body(open));
    EXPECT_FALSE(is_closed_body(plane_mesh({1, 1}, {3, 3})));
}

TEST(ClosedBody, EveryPieceMustBe)
{
    EXPECT_TRUE(is_closed_body(both(box_at(0), box_at(3))));
    EXPECT_FALSE(is_closed_body(both(box_at(0), inside_out(box_at(3)))));
    EXPECT_TRUE(is_closed_body(both(box_at(0), box_at(1)))); // they touch in a face
}

} // namespace trivar::testing
