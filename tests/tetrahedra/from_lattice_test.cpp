// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/from_lattice.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

std::array<Knots, 3> axes(int order, int count)
{
    return {Knots::uniform(order, count), Knots::uniform(order, count, -1, 2),
            Knots::uniform(order, count)};
}

glm::dmat4 turned()
{
    glm::dmat4 out = glm::translate(glm::dmat4(1), glm::dvec3(3, -1, 2));
    return glm::scale(glm::rotate(out, 0.7, glm::dvec3(1, 2, 3)), glm::dvec3(2, 1, 1.5));
}

// Control points displaced by up to `by`, smoothly.
Lattice waved(Lattice lattice, double by)
{
    auto& d = lattice.displacement;
    for (int i = 0; i < d.axes[0].count(); ++i)
        for (int j = 0; j < d.axes[1].count(); ++j)
            for (int k = 0; k < d.axes[2].count(); ++k) {
                const glm::dvec3 g = greville(lattice, {i, j, k});
                d.points[d.index(i, j, k)] =
                    by * glm::dvec3(std::sin(3 * g.y), std::cos(2 * g.z + g.x), g.x * g.y);
            }
    return lattice;
}

TEST(FromLattice, KeepsALatticeAtRest)
{
    const ConvertedLattice out = from_lattice(lattice_at_rest(axes(4, 6), turned()));
    EXPECT_EQ(out.most, 0);
    for (const glm::dvec3& d : out.volume.displacements) EXPECT_EQ(d, glm::dvec3(0));
}

TEST(FromLattice, MeetsPolynomialsOfItsDegree)
{
    // order 2 has degree 3 in all: u v w
    for (const int order : {2, 3}) {
        Lattice lattice = waved(lattice_at_rest(axes(order, order), turned()), 0.3);
        if (order == 3) // a parabola along u alone
            for (std::size_t p = 0; p < 27; ++p)
                lattice.displacement.points[p] = glm::dvec3(p / 9 == 1 ? 1 : 0, 0, 0);
        for (const bool clamped : {false, true}) {
            const ConvertedLattice out = from_lattice(
                lattice,
                {.style = {.border = clamped ? CloudBorder::stacked : CloudBorder::outside}});
            EXPECT_LE(out.most, 1e-12) << order << clamped;
        }
    }
}

TEST(FromLattice, MeetsALatticeOfOrderTwoInAllItsSpans)
{
    // cubic in each span, continuous between them
    const Lattice lattice = waved(lattice_at_rest(axes(2, 4), turned()), 0.3);
    const ConvertedLattice out = from_lattice(lattice);
    EXPECT_LE(out.most, 1e-12);
    const SimplexDomain<3>& domain = out.volume.layers[0]->domain();
    EXPECT_TRUE(domain.cuts.empty());
    EXPECT_FALSE(domain.seams.empty());
}

TEST(FromLattice, StaysInOnePieceAtSeamsThatArePulled)
{
    ConvertedLattice out = from_lattice(lattice_at_rest(axes(2, 3), glm::dmat4(1)));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-0.1, 0.1);
    for (glm::dvec3& each : out.volume.displacements)
        each = {anywhere(random), anywhere(random), anywhere(random)};
    for (const double v : {-0.7, 0.1, 1.3}) {
        const auto at = [&](double u) { return evaluate(out.volume, {u, v, 0.3}).position; };
        EXPECT_LE(glm::distance(at(0.5 - 1e-9), at(0.5 + 1e-9)), 1e-6);
    }
}

TEST(FromLattice, ComesNearerByItsOrderWithThePieces)
{
    const Lattice lattice = waved(lattice_at_rest(axes(4, 5), turned()), 0.2);
    for (int degree = 1; degree <= 3; ++degree) {
        const int pieces = degree == 1 ? 2 : 1;
        const double coarse = from_lattice(lattice, {degree, pieces, {}}).mean;
        const double fine = from_lattice(lattice, {degree, 2 * pieces, {}}).mean;
        EXPECT_LE(fine, coarse / std::pow(2, degree + 0.5)) << degree << " " << coarse;
    }
}

TEST(FromLattice, SaysTheDeviationThatIsThere)
{
    const Lattice lattice = waved(lattice_at_rest(axes(4, 5), turned()), 0.2);
    const ConvertedLattice out = from_lattice(lattice);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 1);
    double most = 0;
    for (int n = 0; n < 2000; ++n) {
        const glm::dvec3 uvw{anywhere(random), 3 * anywhere(random) - 1, anywhere(random)};
        const glm::dvec3 x(lattice.rest * glm::dvec4(uvw, 1));
        const glm::dvec3 there = evaluate(lattice, uvw).value;
        most = std::max(most, glm::distance(evaluate(out.volume, x).position, there));
    }
    EXPECT_GT(out.most, 0);
    EXPECT_LE(most, 1.5 * out.most);
    EXPECT_LE(out.mean, out.most);
}

TEST(FromLattice, TearsWhereTheLatticeIsTorn)
{
    // two clamped pieces along u; the second one is lifted
    const Knots u = Knots::general(2, {0, 0, 0.5, 0.5, 1, 1});
    Lattice lattice =
        lattice_at_rest({u, Knots::uniform(2, 2), Knots::uniform(2, 2)}, glm::dmat4(1));
    for (std::size_t p = 8; p < 16; ++p) lattice.displacement.points[p] = glm::dvec3(0, 0, 1);
    for (int degree = 1; degree <= 3; ++degree) {
        const ConvertedLattice out = from_lattice(lattice, {.degree = degree});
        EXPECT_LE(out.most, 1e-12) << degree;
        EXPECT_NEAR(evaluate(out.volume, {0.5 - 1e-6, 0.3, 0.4}).position.z, 0.4, 1e-9);
        EXPECT_NEAR(evaluate(out.volume, {0.5 + 1e-6, 0.3, 0.4}).position.z, 1.4, 1e-9);
    }
}

TEST(FromLattice, TakesMirroredLatticesAndRefusesFlatOnes)
{
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    EXPECT_LE(from_lattice(waved(lattice_at_rest(axes(2, 3), mirror), 0.1)).most, 1e-12);
    const glm::dmat4 flat = glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1));
    EXPECT_THROW(from_lattice(lattice_at_rest(axes(2, 2), flat)), Rejected);
    EXPECT_THROW(from_lattice(lattice_at_rest(axes(2, 2), mirror), {.degree = 4}), Rejected);
    EXPECT_THROW(from_lattice(lattice_at_rest(axes(2, 2), mirror), {.pieces = 0}), Rejected);
    EXPECT_THROW(from_lattice(lattice_at_rest(axes(2, 60), mirror), {.pieces = 10}), Rejected);
}

TEST(FromLattice, GivesTheSameBitsOnOneThread)
{
    const Lattice lattice = waved(lattice_at_rest(axes(4, 5), turned()), 0.2);
    const ConvertedLattice many = from_lattice(lattice);
    const ThreadLimit limit(1);
    const ConvertedLattice one = from_lattice(lattice);
    EXPECT_EQ(many.volume.displacements, one.volume.displacements);
    EXPECT_EQ(many.mean, one.mean);
}

} // namespace
} // namespace trivar
