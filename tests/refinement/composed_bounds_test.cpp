// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/composed_bounds.h"

#include "core/base/index.h"
#include "tests/refinement/bent.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

Lattice noisy_lattice(int order, int count, double height, unsigned seed,
                      Closure along = Closure::open)
{
    const Knots across = Knots::uniform(order, count, -0.5, 1.5);
    Lattice lattice = lattice_at_rest(
        {along == Closure::open ? across : Knots::periodic(order, count, 0, 1, along), across,
         across},
        glm::dmat4(1));
    Noise noise(seed);
    for (glm::dvec3& d : lattice.displacement.points) d = height * noise.vec3();
    return lattice;
}

NextVolume after_turning(Lattice lattice, const Noise&, double angle)
{
    NextVolume out;
    out.embedding.to_uvw = glm::rotate(glm::dmat4(1), angle, glm::dvec3(1, 2, 3)) *
                           glm::scale(glm::dmat4(1), glm::dvec3(1.5, 0.7, 1));
    out.embedding.to_rest = glm::rotate(glm::dmat4(1), -angle, glm::dvec3(0, 1, 0));
    out.lattice = make_ref(std::move(lattice));
    return out;
}

TEST(StretchBounds, ExceedTheStretchBetweenAnyTwoPointsOfABox)
{
    Noise noise(7);
    for (const Closure along : {Closure::open, Closure::periodic, Closure::twisted})
        for (int order = 2; order <= 5; ++order) {
            const NextVolume volume = after_turning(
                noisy_lattice(order, 7, 0.3, 40u + static_cast<unsigned>(order), along), noise,
                0.4);
            const DisplacementCells cells(volume.lattice->displacement);
            const StretchBound stretch(cells, volume.embedding);
            const glm::dmat4 from_uvw = glm::inverse(volume.embedding.to_uvw);
            double closest = 0;
            for (int n = 0; n < 6000; ++n) {
                const glm::dvec3 lo = 1.3 * noise.vec3(), hi = lo + 0.1 * glm::abs(noise.vec3());
                const double most = stretch.over(lo, hi);
                EXPECT_LE(most, stretch.most());
                const auto somewhere = [&] {
                    const glm::dvec3 uvw = glm::mix(lo, hi, 0.5 + 0.5 * noise.vec3());
                    return glm::dvec3(from_uvw * glm::dvec4(uvw, 1));
                };
                const glm::dvec3 p = somewhere(), q = somewhere();
                const double ratio =
                    glm::distance(through(volume, p), through(volume, q)) / glm::distance(p, q);
                ASSERT_LE(ratio, most)
                    << "order " << order << ", closure " << static_cast<int>(along);
                closest = std::max(closest, ratio / most);
            }
            EXPECT_GT(closest, 0.5) << "the bound says too little for order " << order;
        }
}

TEST(ComposedBounds, AreNeverBelowTheSampledTruthOfTwoAndThreeVolumes)
{
    Noise noise(11);
    std::vector<double> ratios;
    for (int n = 0; n < 60; ++n) {
        const int order = 2 + n % 4;
        const auto seed = static_cast<unsigned>(100 + n);
        const Lattice first = noisy_lattice(order, 6, 0.2, seed);
        std::vector<NextVolume> next{after_turning(noisy_lattice(4, 6, 0.2, seed + 1), noise, 0.3)};
        if (n % 2 == 1)
            next.push_back(after_turning(noisy_lattice(3, 5, 0.2, seed + 2), noise, -0.5));
        Mesh mesh;
        const double size = std::pow(10, -0.5 - 1.5 * (n % 7) / 7.0);
        const glm::dvec3 middle = 0.4 * noise.vec3() + 0.5;
        for (int i = 0; i < 3; ++i) mesh.positions.emplace_back(middle + size * noise.vec3());
        add_face(mesh, std::array<std::uint32_t, 3>{0, 1, 2});
        const RefinementResult found =
            bounded({{make_ref(mesh), {}}}, first, {.tolerance_world = 10}, {}, next);
        Mesh drawn = deform(mesh, {}, first);
        for (const NextVolume& each : next) drawn = deform(drawn, each.embedding, *each.lattice);
        double truth = 0;
        constexpr int levels = 16;
        for (int i = 0; i <= levels; ++i)
            for (int j = 0; i + j <= levels; ++j) {
                const glm::dvec3 share(double(i) / levels, double(j) / levels,
                                       1 - double(i + j) / levels);
                glm::dvec3 p(0), flat(0);
                for (int c = 0; c < 3; ++c) {
                    p += share[c] * glm::dvec3(mesh.positions[at(c)]);
                    flat += share[c] * glm::dvec3(drawn.positions[at(c)]);
                }
                truth =
                    std::max(truth, glm::distance(flat, through(next, evaluate(first, p).value)));
            }
        ASSERT_LE(truth, found.bound) << "case " << n;
        ratios.push_back(found.bound / truth);
    }
    std::ranges::nth_element(ratios, ratios.begin() + 30);
    EXPECT_LT(ratios[30], 5) << "bound by truth, in the middle of all cases";
}

TEST(ComposedBounds, OfAVolumeAtRestBehindAnotherAreThoseOfTheFirst)
{
    const Lattice first = noisy_lattice(4, 6, 0.2, 5);
    const Lattice at_rest = noisy_lattice(4, 6, 0, 5);
    const Ref<Mesh> ball = make_ref(sphere_mesh(0.4, 24, 16));
    const RefineOptions options{.tolerance_world = 1};
    const double alone = bounded({{ball, {}}}, first, options).bound,
                 both = bounded({{ball, {}}}, first, options, {}, {{{}, make_ref(at_rest)}}).bound;
    EXPECT_NEAR(both, alone, 1e-6 * alone);
}

TEST(ComposedBounds, LeadToTrianglesThatAreDrawnWithinTheTolerance)
{
    const Lattice first = one_cell(4, twist);
    const std::vector<NextVolume> next{{{}, make_ref(one_cell(4, bend))}};
    constexpr double tolerance = 2e-3;
    const Mesh cube = unit_cube();
    const RefinementResult out =
        refine({{make_ref(cube), {}}}, first, {.tolerance_world = tolerance}, {}, next);
    EXPECT_EQ(out.not_certified(), 0u);
    EXPECT_LE(out.bound, tolerance);
    EXPECT_LT(out.triangles(), 40'000u);
    const Mesh& fine = *out.parts[0].mesh;
    const Mesh drawn = deform(deform(fine, {}, first), {}, *next[0].lattice);
    double truth = 0;
    for (const glm::uvec3& t : triangles(fine)) {
        const auto middle = [&](const Mesh& mesh) {
            return (glm::dvec3(mesh.positions[t.x]) + glm::dvec3(mesh.positions[t.y]) +
                    glm::dvec3(mesh.positions[t.z])) /
                   3.0;
        };
        truth = std::max(truth, glm::distance(middle(drawn),
                                              through(next, evaluate(first, middle(fine)).value)));
    }
    EXPECT_LE(truth, out.bound);
    EXPECT_GT(truth, 0.1 * tolerance) << "not one triangle comes near the tolerance";
}

} // namespace
} // namespace trivar
