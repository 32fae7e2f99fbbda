// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/deform.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

using namespace testing;

std::array<Knots, 3> uniform_axes(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    return {knots, knots, knots};
}

TEST(Deform, ByALatticeOfZerosReturnsTheVeryBits)
{
    Mesh mesh = scattered_points(1000, -0.5, 1.5);
    mesh.positions[0] = {-0.0f, 0.0f, 1e-42f};
    mesh.normals[1] = {0, 0, 2}; // not unit: still not ours to change
    mesh.normals[2] = {0, 0, 0};
    for (const int order : {2, 3, 4, 6}) {
        const Mesh out = deform(mesh, {}, lattice_at_rest(uniform_axes(order, 7), glm::dmat4(1)));
        EXPECT_EQ(bits(out.positions), bits(mesh.positions));
        EXPECT_EQ(bits(out.normals), bits(mesh.normals));
        EXPECT_EQ(out, mesh);
    }
}

TEST(Deform, ByALatticeOfZerosAndAnAffineRestIsThatMap)
{
    const Mesh mesh = scattered_points(1000);
    const Lattice lattice = lattice_at_rest(uniform_axes(4, 6), some_affine_map());
    const Mesh out = deform(mesh, {glm::dmat4(1), some_affine_map()}, lattice);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_EQ(out.positions[v],
                  glm::vec3(some_affine_map() * glm::dvec4(mesh.positions[v], 1)));
    const Mesh expected = deform_in_double(mesh, {glm::dmat4(1), some_affine_map()}, lattice);
    EXPECT_LT(largest_distance(out.normals, expected.normals), 1e-6);
}

TEST(Deform, ReproducesAnAffineMapGivenByControlPoints)
{
    const Mesh mesh = scattered_points(1000);
    Lattice lattice = lattice_at_rest(uniform_axes(4, 6), some_affine_map());
    Trivariate<glm::dvec3> points = lattice.displacement;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            for (int k = 0; k < 6; ++k)
                points.points[points.index(i, j, k)] = control_point(lattice, i, j, k);
    lattice = lattice_through(points);
    const Mesh out = deform(mesh, {glm::dmat4(1), lattice.rest}, lattice);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_LT(glm::distance(glm::dvec3(out.positions[v]),
                                glm::dvec3(some_affine_map() * glm::dvec4(mesh.positions[v], 1))),
                  2e-6);
}

// Single precision has steps of 1.2e-7 relative; a position is allowed eight of them.
void expect_close_to_double(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice)
{
    const Mesh out = deform(mesh, embedding, lattice);
    const Mesh exact = deform_in_double(mesh, embedding, lattice);
    double extent = 1;
    for (const glm::vec3& p : exact.positions) extent = std::max(extent, double{glm::length(p)});
    EXPECT_LT(largest_distance(out.positions, exact.positions), 1e-6 * extent);
    // Where J is nearly singular a normal amplifies errors without bound, so nearly all is asked.
    std::size_t off = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(out.normals[v]), 1, 1e-6);
        EXPECT_NEAR(glm::length(glm::vec3(out.tangents[v])), 1, 1e-6);
        EXPECT_NEAR(glm::dot(glm::vec3(out.tangents[v]), out.normals[v]), 0, 1e-5);
        EXPECT_EQ(out.tangents[v].w, mesh.tangents[v].w);
        off += glm::distance(out.normals[v], exact.normals[v]) > 2e-5;
        off += glm::distance(out.tangents[v], exact.tangents[v]) > 2e-4;
    }
    EXPECT_LT(off, mesh.vertex_count() / 100);
}

TEST(Deform, AgreesWithDoubleForAllOrders)
{
    const Mesh mesh = scattered_points(500, -0.1f, 1.1f);
    for (int u = 2; u <= 6; ++u)
        for (int v = 2; v <= 6; ++v)
            for (int w = 2; w <= 6; ++w) {
                SCOPED_TRACE(std::to_string(u) + std::to_string(v) + std::to_string(w));
                const std::array<Knots, 3> axes{Knots::uniform(u, 8), uneven_knots(v),
                                                Knots::uniform(w, w)};
                expect_close_to_double(mesh, {}, random_lattice(axes, 0.3));
            }
}

TEST(Deform, AgreesWithDoubleRoundClosedAxes)
{
    const Mesh mesh = scattered_points(2000, -2, 3);
    const Closure closures[]{Closure::open, Closure::periodic, Closure::twisted};
    for (const Closure u : closures)
        for (const Closure v : closures)
            for (const Closure w : closures) {
                const auto axis = [](Closure closure, int order, int count) {
                    return closure == Closure::open ? Knots::uniform(order, count)
                                                    : Knots::periodic(order, count, 0, 1, closure);
                };
                const std::array<Knots, 3> axes{axis(u, 3, 6), axis(v, 4, 5), axis(w, 3, 4)};
                expect_close_to_double(mesh, {}, random_lattice(axes, 0.05));
            }
}

TEST(Deform, AgreesWithDoubleThroughAffineMaps)
{
    const Mesh mesh = scattered_points(2000, -3, 3);
    const Embedding embedding{glm::inverse(some_affine_map()), some_affine_map()};
    expect_close_to_double(mesh, embedding, random_lattice(uniform_axes(4, 5), 0.2));
}

TEST(Deform, GivesNormalsThatFiniteDifferencesConfirm)
{
    const Mesh mesh = scattered_points(500, 0.01f, 0.99f);
    const Lattice lattice = random_lattice(uniform_axes(4, 6), 0.05);
    const Mesh out = deform(mesh, {}, lattice);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::dvec3 n(mesh.normals[v]), t(mesh.tangents[v]), b = glm::cross(n, t);
        const auto moved = [&](glm::dvec3 by) {
            return deform(glm::dvec3(mesh.positions[v]) + by, {}, lattice).position_world;
        };
        const double h = 1e-5;
        const glm::dvec3 expected =
            glm::normalize(glm::cross(moved(h * t) - moved(-h * t), moved(h * b) - moved(-h * b)));
        EXPECT_LT(glm::distance(glm::dvec3(out.normals[v]), expected), 1e-5);
    }
}

TEST(Deform, GivesAVertexTheSameBitsInAnyCompany)
{
    const Lattice lattice = random_lattice(uniform_axes(4, 8), 0.1);
    const Mesh mesh = scattered_points(3000);
    Mesh twice = mesh; // everything again, in reverse order, after an odd number of others
    const Mesh others = scattered_points(1237, 0, 1, 7);
    for (std::size_t i = 0; i < others.vertex_count(); ++i) {
        twice.positions.push_back(others.positions[i]);
        twice.normals.push_back(others.normals[i]);
        twice.tangents.push_back(others.tangents[i]);
    }
    for (std::size_t i = mesh.vertex_count(); i-- > 0;) {
        twice.positions.push_back(mesh.positions[i]);
        twice.normals.push_back(mesh.normals[i]);
        twice.tangents.push_back(mesh.tangents[i]);
    }
    const Mesh alone = deform(mesh, {}, lattice), out = deform(twice, {}, lattice);
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const std::size_t again = twice.vertex_count() - 1 - i;
        EXPECT_EQ(out.positions[i], alone.positions[i]);
        EXPECT_EQ(out.positions[again], alone.positions[i]);
        EXPECT_EQ(out.normals[again], alone.normals[i]);
        EXPECT_EQ(out.tangents[again], alone.tangents[i]);
    }
}

TEST(Deform, GivesTheSameBitsForAnyNumberOfThreads)
{
    const Mesh mesh = scattered_points(100000);
    const Lattice lattice = random_lattice(uniform_axes(3, 9), 0.1);
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return deform(mesh, {}, lattice);
    };
    EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(Deform, ReusesStorageWhateverItHolds)
{
    const Mesh mesh = scattered_points(5000);
    const Lattice lattice = random_lattice(uniform_axes(4, 6), 0.1);
    const Deformer deformer(make_ref(mesh), {}, lattice.displacement.axes);
    const DeformedArrays fresh = deformer.arrays(lattice);
    DeformedArrays used{{{1, 2, 3}}, std::vector<glm::vec3>(9999), {}};
    used = deformer.arrays(lattice, std::move(used));
    EXPECT_EQ(used.positions, fresh.positions);
    EXPECT_EQ(used.normals, fresh.normals);
    EXPECT_EQ(used.tangents, fresh.tangents);
}

TEST(Deform, KeepsAnEmptyMeshAndAMeshWithoutNormals)
{
    const Lattice lattice = random_lattice(uniform_axes(4, 6), 0.1);
    EXPECT_EQ(deform(Mesh{}, {}, lattice), Mesh{});
    Mesh bare = scattered_points(100);
    const Mesh full = deform(bare, {}, lattice);
    bare.normals.clear();
    bare.tangents.clear();
    const Mesh out = deform(bare, {}, lattice);
    EXPECT_EQ(out.positions, full.positions);
    EXPECT_TRUE(out.normals.empty());
}

TEST(Deform, ConfinesAControlPointThatIsNoNumberToItsSupport)
{
    const Mesh mesh = scattered_points(5000);
    Lattice lattice = random_lattice(uniform_axes(3, 8), 0.1);
    const Mesh good = deform(mesh, {}, lattice);
    lattice.displacement.points[lattice.displacement.index(0, 3, 4)].y =
        std::numeric_limits<double>::quiet_NaN();
    const Mesh out = deform(mesh, {}, lattice);
    // Order 3 over 6 spans: point i reaches spans i-2..i, of 1/6 each.
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::vec3 span = glm::floor(mesh.positions[v] * 6.0f);
        const bool reached = span.x < 1 && span.y >= 1 && span.y < 4 && span.z >= 2 && span.z < 5;
        EXPECT_EQ(std::isnan(out.positions[v].y), reached);
        if (!reached) {
            EXPECT_EQ(out.normals[v], good.normals[v]);
        }
        EXPECT_FALSE(std::isnan(out.normals[v].x + out.tangents[v].x));
    }
}

TEST(Deform, SurvivesVerticesThatAreNoNumbersOrFarAway)
{
    Mesh mesh = scattered_points(8);
    const float infinite = std::numeric_limits<float>::infinity();
    mesh.positions[1].x = std::numeric_limits<float>::quiet_NaN();
    mesh.positions[2].y = infinite;
    mesh.positions[3].z = -infinite;
    mesh.positions[4] = {1e30f, -1e30f, 1e30f};
    const Closure closures[]{Closure::periodic, Closure::twisted};
    for (const Closure closure : closures) {
        const Knots closed = Knots::periodic(4, 5, 0, 1, closure);
        const Lattice lattice = random_lattice({closed, closed, Knots::uniform(3, 4)}, 0.1);
        const Mesh out = deform(mesh, {}, lattice);
        EXPECT_TRUE(std::isnan(out.positions[1].x));
        EXPECT_TRUE(std::isfinite(out.positions[4].x));
        EXPECT_TRUE(std::isfinite(out.positions[0].x));
    }
}

TEST(Deform, ByAMirroringLatticeKeepsNormalsWithTheWinding)
{
    Mesh mesh = scattered_points(0);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.corners = {0, 1, 2, 3};
    mesh.face_begin = {0, 4};
    glm::dmat4 mirror(1);
    mirror[0][0] = -1;
    const Mesh out =
        deform(mesh, {glm::dmat4(1), mirror}, lattice_at_rest(uniform_axes(3, 3), mirror));
    EXPECT_EQ(out.corners, mesh.corners);
    EXPECT_EQ(out.normals[0], glm::vec3(0, 0, -1)); // the square is seen from behind now
    EXPECT_EQ(out.tangents[0], glm::vec4(-1, 0, 0, 1));
}

TEST(Deform, TakesANormalThatJCannotTellFromTheFaces)
{
    // u, v, w go to a line: J has rank 1, cof(J) is zero, and the faces have no area either.
    Mesh mesh = scattered_points(0);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.corners = {0, 1, 2};
    mesh.face_begin = {0, 3};
    glm::dmat4 line(0);
    line[0][0] = line[3][3] = 1;
    const Lattice still = lattice_at_rest(uniform_axes(3, 3), line);
    EXPECT_EQ(deform(mesh, {glm::dmat4(1), line}, still).normals, mesh.normals);

    // Here it is so at one vertex only, and a face bends away from it: z = x^2 y^2, x, y squared.
    Lattice bent = still;
    bent.displacement.points[bent.displacement.index(2, 2, 0)] = {0, 1, 0};
    bent.displacement.points[bent.displacement.index(0, 2, 0)] = {0, 1, 0};
    const Mesh out = deform(mesh, {glm::dmat4(1), line}, bent);
    EXPECT_EQ(out.normals[0], glm::vec3(0, 0, 1));
}

TEST(Deform, MovesPointsBeyondTheDomainWithItsNearestEnd)
{
    Mesh mesh;
    mesh.positions = {{0.5f, 0.5f, 1}, {0.5f, 0.5f, 3}};
    mesh.normals.assign(2, glm::normalize(glm::vec3(1, 2, 3)));
    const Lattice lattice = random_lattice(uniform_axes(4, 6), 0.1);
    const Mesh out = deform(mesh, {}, lattice);
    EXPECT_LT(glm::distance(out.positions[1] - out.positions[0], glm::vec3(0, 0, 2)), 1e-6f);
    const Mesh exact = deform_in_double(mesh, {}, lattice);
    EXPECT_LT(largest_distance(out.normals, exact.normals), 1e-6);
}

// Not reached by a coordinate: digits of the displacement must not drown in the world's offset.
TEST(Deform, KeepsDigitsFarFromTheOrigin)
{
    const Mesh mesh = scattered_points(500);
    const Lattice lattice = random_lattice(uniform_axes(4, 5), 0.1);
    glm::dmat4 far(1);
    far[3] = {4096, 4096, 4096, 1};
    const Mesh out = deform(mesh, {glm::dmat4(1), far}, lattice);
    const Mesh exact = deform_in_double(mesh, {glm::dmat4(1), far}, lattice);
    EXPECT_LT(largest_distance(out.positions, exact.positions), 4096 * 2.5e-7);
    EXPECT_LT(largest_distance(out.normals, exact.normals), 2e-6);
}

} // namespace
} // namespace trivar
