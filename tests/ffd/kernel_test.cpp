// SPDX-License-Identifier: GPL-3.0-or-later
// Textbook against core/kernel as C++. tests/gpu/deform_test.cpp goes on to the device.
#include "core/ffd/packed_volume.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// The recursion of Cox and de Boor; 0/0 is 0. The last span of the domain is closed.
double textbook(const Knots& knots, int i, int order, double t)
{
    const std::vector<double>& k = knots.values();
    const auto at = [&](int n) { return k[static_cast<std::size_t>(n)]; };
    if (order == 1) {
        const int span = knots.span(t);
        return i == span ? 1 : 0;
    }
    double sum = 0;
    if (const double length = at(i + order - 1) - at(i); length > 0)
        sum += (t - at(i)) / length * textbook(knots, i, order - 1, t);
    if (const double length = at(i + order) - at(i + 1); length > 0)
        sum += (at(i + order) - t) / length * textbook(knots, i + 1, order - 1, t);
    return sum;
}

double textbook_slope(const Knots& knots, int i, double t)
{
    const std::vector<double>& k = knots.values();
    const auto at = [&](int n) { return k[static_cast<std::size_t>(n)]; };
    const int d = knots.degree();
    double sum = 0;
    if (const double length = at(i + d) - at(i); length > 0)
        sum += d / length * textbook(knots, i, d, t);
    if (const double length = at(i + d + 1) - at(i + 1); length > 0)
        sum -= d / length * textbook(knots, i + 1, d, t);
    return sum;
}

struct Exact {
    glm::dvec3 value{0};
    glm::dmat3 by_uvw{0};
};

// The sum over all control points, in the domain of the axes.
Exact textbook(const Trivariate<glm::dvec3>& f, glm::dvec3 uvw)
{
    std::array<std::vector<double>, 3> value, slope;
    for (std::size_t a = 0; a < 3; ++a)
        for (int i = 0; i < f.axes[a].unwrapped_count(); ++i) {
            const double t = uvw[static_cast<int>(a)];
            value[a].push_back(textbook(f.axes[a], i, f.axes[a].order(), t));
            slope[a].push_back(textbook_slope(f.axes[a], i, t));
        }
    Exact out;
    for (std::size_t i = 0; i < value[0].size(); ++i)
        for (std::size_t j = 0; j < value[1].size(); ++j)
            for (std::size_t k = 0; k < value[2].size(); ++k) {
                const glm::dvec3 p =
                    f.point(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k));
                out.value += p * (value[0][i] * value[1][j] * value[2][k]);
                out.by_uvw[0] += p * (slope[0][i] * value[1][j] * value[2][k]);
                out.by_uvw[1] += p * (value[0][i] * slope[1][j] * value[2][k]);
                out.by_uvw[2] += p * (value[0][i] * value[1][j] * slope[2][k]);
            }
    return out;
}

// A lattice of one unit beside its kernel; object space is parameter space.
struct PackedVolume {
    explicit PackedVolume(const std::array<Knots, 3>& axes, double size = 0.3)
        : lattice(random_lattice(axes, size)),
          packed(packed_axes(axes)),
          points(packed_points(lattice.displacement))
    {
        Box box;
        box.add({axes[0].begin(), axes[1].begin(), axes[2].begin()});
        box.add({axes[0].end(), axes[1].end(), axes[2].end()});
        frame = volume_frame(lattice, packed, {}, box);
    }
    template <int u, int v, int w> kernel::VolumeKernel<u, v, w> kernel() const
    {
        return {frame, points, packed.cells};
    }
    Lattice lattice;
    PackedAxes packed;
    std::vector<glm::vec4> points;
    VolumeFrame frame;
};

// Parameters all over a domain, with every knot and both ends among them.
std::vector<double> parameters(const Knots& knots)
{
    std::vector<double> out = inside(knots, 5);
    const std::vector<double> breaks = knots.breaks();
    out.insert(out.end(), breaks.begin(), breaks.end());
    return out;
}

// Where a derivative jumps, sides may differ by rounding.
bool at_a_kink(const Knots& knots, double t)
{
    const double slack = 1e-6 * (knots.end() - knots.begin());
    for (const double k : knots.breaks()) {
        const bool end = k == knots.begin() || k == knots.end();
        if (std::abs(k - t) < slack && !(end && knots.closure() == Closure::open) &&
            knots.order() - knots.multiplicity(k) < 2)
            return true;
    }
    return false;
}

template <int u, int v, int w> void expect_textbook(const std::array<Knots, 3>& axes)
{
    const PackedVolume volume(axes);
    auto kernel = volume.kernel<u, v, w>();
    for (const double a : parameters(axes[0]))
        for (const double b : parameters(axes[1]))
            for (const double c : parameters(axes[2])) {
                const glm::vec3 p(a, b, c);
                glm::dvec3 t(p);
                bool kink = false;
                for (int x = 0; x < 3; ++x) {
                    const Knots& knots = axes[static_cast<std::size_t>(x)];
                    t[x] = std::clamp(t[x], knots.begin(), knots.end());
                    kink = kink || at_a_kink(knots, t[x]);
                }
                const Exact exact = textbook(volume.lattice.displacement, t);
                const auto got = kernel.deformed_point(p);
                EXPECT_LT(glm::length(glm::dvec3(got.position) - glm::dvec3(p) - exact.value),
                          1e-6);
                const auto raised =
                    kernel.displaced(p, kernel.raised_displacement(kernel.spot_at(kernel.x_of(p))));
                EXPECT_LT(glm::length(glm::dvec3(raised) - glm::dvec3(got.position)), 2e-6);
                if (kink) continue;
                const glm::dmat3 j = glm::dmat3(1) + exact.by_uvw;
                const double scale = volume.frame.jacobian_scale;
                for (int x = 0; x < 3; ++x)
                    EXPECT_LT(glm::length(glm::dvec3(got.jacobian[x]) / scale - j[x]), 3e-5);
            }
}

// Every kind of axis, no two of the same order in the same place.
TEST(Kernel, AgreesWithTheTextbookAtKnotsAndEndsForMixedOrders)
{
    const auto loose = [](int order) { // no knot repeats
        std::vector<double> t;
        for (int i = 0; i < 2 * order + 3; ++i) t.push_back(0.1 * i + 0.01 * (i % 3));
        return Knots::general(order, t);
    };
    expect_textbook<2, 3, 4>({Knots::uniform(2, 5), uneven_knots(3), loose(4)});
    expect_textbook<4, 2, 3>({Knots::periodic(4, 5), loose(2), Knots::uniform(3, 7)});
    expect_textbook<3, 4, 2>({uneven_knots(3), Knots::uniform(4, 4), Knots::periodic(2, 3)});
    expect_textbook<4, 4, 4>({uneven_knots(4), Knots::uniform(4, 9), loose(4)});
}

// p deformed by the kernel against the double reference of core/ffd, which knows of ends, turns and
// twists. Positions in millionths of the deformed box, normals in degrees.
template <int u, int v, int w>
void expect_reference(const std::array<Knots, 3>& axes, const Embedding& embedding,
                      const Mesh& mesh)
{
    const Lattice lattice = random_lattice(axes, 0.1);
    const PackedAxes packed = packed_axes(axes);
    const std::vector<glm::vec4> points = packed_points(lattice.displacement);
    const VolumeFrame frame = volume_frame(lattice, packed, embedding, bounding_box(mesh));
    kernel::VolumeKernel<u, v, w> kernel{frame, points, packed.cells};
    const Mesh exact = deform_in_double(mesh, embedding, lattice);
    const double extent = glm::length(bounding_box(exact).size());
    std::size_t off = 0;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const auto got = kernel.deformed_point(mesh.positions[i]);
        EXPECT_LT(glm::distance(glm::dvec3(got.position), glm::dvec3(exact.positions[i])),
                  1e-6 * extent);
        const glm::vec3 n = kernel.deformed_normal(got.jacobian, mesh.normals[i]);
        const glm::vec4 t = kernel.deformed_tangent(got.jacobian, mesh.tangents[i], n);
        EXPECT_NEAR(glm::dot(glm::vec3(t), n), 0, 1e-5);
        EXPECT_EQ(t.w, mesh.tangents[i].w);
        off += angle_deg(n, exact.normals[i]) > 0.05;
        off += angle_deg(glm::vec3(t), glm::vec3(exact.tangents[i])) > 0.05;
    }
    // Kinks of order 2, and what is nearly singular.
    EXPECT_LE(off, mesh.vertex_count() / 500);
}

TEST(Kernel, AgreesWithDoubleBeyondEndsAndRoundClosedAxes)
{
    const Mesh mesh = scattered_points(3000, -2, 3);
    const auto closed = [](int order, Closure closure) {
        return Knots::periodic(order, order + 3, 0, 1, closure);
    };
    const Closure twisted = Closure::twisted;
    expect_reference<3, 3, 3>(
        {Knots::uniform(3, 6), closed(3, Closure::periodic), Knots::uniform(3, 4)}, {}, mesh);
    expect_reference<3, 3, 3>({closed(3, twisted), Knots::uniform(3, 6), uneven_knots(3)}, {},
                              mesh);
    expect_reference<3, 3, 3>(
        {closed(3, twisted), closed(3, twisted), closed(3, Closure::periodic)}, {}, mesh);
    expect_reference<2, 3, 4>(
        {Knots::uniform(2, 4), closed(3, twisted), closed(4, Closure::periodic)}, {}, mesh);
}

TEST(Kernel, AgreesWithDoubleThroughAffineMapsFarFromTheOrigin)
{
    const Mesh mesh = scattered_points(3000, -3, 3);
    const Embedding embedding{glm::inverse(some_affine_map()), some_affine_map()};
    expect_reference<4, 4, 4>({Knots::uniform(4, 8), Knots::uniform(4, 5), uneven_knots(4)},
                              embedding, mesh);
    const Mesh far = scattered_points(3000, 1000, 1001);
    glm::dmat4 back(1);
    back[3] = glm::dvec4(-1000, -1000, -1000, 1);
    expect_reference<4, 4, 4>({Knots::uniform(4, 8), Knots::uniform(4, 5), uneven_knots(4)},
                              {back, back}, far);
}

TEST(Kernel, ReturnsTheVeryBitsOfWhatAnUntouchedLatticeHolds)
{
    const Knots knots = Knots::uniform(3, 7);
    const Lattice still = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    for (const float from : {-0.5f, 0.0f, 77.0f, -3e4f}) {
        const Mesh mesh = scattered_points(500, from, from + 1);
        const PackedAxes packed = packed_axes(still.displacement.axes);
        const std::vector<glm::vec4> points = packed_points(still.displacement);
        const VolumeFrame frame = volume_frame(still, packed, {}, bounding_box(mesh));
        kernel::VolumeKernel<3, 3, 3> kernel{frame, points, packed.cells};
        for (const glm::vec3& p : mesh.positions) EXPECT_EQ(kernel.deformed_point(p).position, p);
    }
}

// The thesis's normals, for comparison: two more evaluations, and off by a part of a degree.
TEST(Kernel, GivesBetterNormalsByCofactorsThanByDifferences)
{
    const PackedVolume volume({Knots::uniform(4, 6), Knots::uniform(4, 6), Knots::uniform(4, 6)},
                              0.05);
    auto kernel = volume.kernel<4, 4, 4>();
    const Mesh mesh = scattered_points(2000);
    const Mesh exact = deform_in_double(mesh, {}, volume.lattice);
    double by_cofactors = 0, by_differences = 0;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const glm::vec3 p = mesh.positions[i], n = mesh.normals[i];
        const auto got = kernel.deformed_point(p);
        const auto plane = kernel.plane_of(n);
        const float step = volume.frame.difference_step;
        const glm::vec3 differences = kernel.difference_normal(
            got.position, kernel.deformed_point(p + step * plane.along).position,
            kernel.deformed_point(p + step * plane.across).position);
        by_cofactors = std::max(
            by_cofactors, angle_deg(kernel.deformed_normal(got.jacobian, n), exact.normals[i]));
        by_differences = std::max(by_differences, angle_deg(differences, exact.normals[i]));
    }
    EXPECT_LT(by_cofactors, 0.001);
    EXPECT_LT(by_differences, 0.5);
    EXPECT_LT(by_cofactors * 20, by_differences);
}

TEST(Kernel, RefusesOrdersItDoesNotKnow)
{
    const Knots five = Knots::uniform(5, 6), three = Knots::uniform(3, 6);
    EXPECT_THROW(packed_axes({three, five, three}), std::exception);
}

} // namespace
} // namespace trivar
