// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/pressing.h"

#include "core/base/rejected.h"
#include "core/placement/shaper.h"
#include "tests/ffd/folds.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

// A box of 2 x 1 x 0.5 metres, somewhat bent, symmetric about v = 1/2.
Lattice bent_box(int order = 3)
{
    const std::array<Knots, 3> axes{Knots::uniform(order, 12), Knots::uniform(order, 8),
                                    Knots::uniform(order, 5)};
    Lattice out =
        lattice_at_rest(axes, glm::dmat4(2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1));
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 5; ++k)
                out.displacement.points[out.displacement.index(i, j, k)].z =
                    0.1 * std::sin(0.4 * i);
    return out;
}

Press press_at(glm::dvec4 sample, Decay decay = Decay::gaussian)
{
    return {.decay = decay, .radius = 0.4, .samples = {sample}};
}

Lattice pressed(const Press& press)
{
    Pressing pressing(laid_volume(bent_box(), 0), press);
    for (const glm::dvec4& sample : press.samples) pressing.add(sample);
    return pressing.volume();
}

double farthest(const Lattice& a, const Lattice& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.displacement.points.size(); ++i)
        most = std::max(most, glm::distance(a.displacement.points[i], b.displacement.points[i]));
    return most;
}

TEST(Decay, FallsFromOneToNothingAtTheRim)
{
    for (const Decay kind : {Decay::gaussian, Decay::hat, Decay::box, Decay::smooth}) {
        EXPECT_EQ(decay(kind, 0), 1);
        EXPECT_EQ(decay(kind, 1), 0);
        for (double x = 0; x < 1; x += 0.01) EXPECT_GE(decay(kind, x), decay(kind, x + 0.01));
    }
    for (const Decay kind : {Decay::gaussian, Decay::hat, Decay::smooth})
        EXPECT_LT(decay(kind, 1 - 1e-6), 1e-5);
}

TEST(Pressing, OfNothingIsTheVolumeToTheLastBit)
{
    EXPECT_EQ(pressed(press_at({0.5, 0.5, 1, 0})), bent_box());
}

TEST(Pressing, TakesTheRoofTowardTheSceneAndLeavesWhatIsOutsideTheBall)
{
    const Lattice before = bent_box(), after = pressed(press_at({0.5, 0.5, 1, 0.05}));
    const glm::dvec3 center = evaluate(before, {0.5, 0.5, 1}).value;
    int lowered = 0;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 5; ++k) {
                const glm::dvec3 a = control_point(before, i, j, k),
                                 b = control_point(after, i, j, k);
                if (k == 0 || glm::distance(a, center) >= 0.4) {
                    EXPECT_EQ(a, b);
                    continue;
                }
                EXPECT_LT(b.z, a.z);
                ++lowered;
            }
    EXPECT_GT(lowered, 8);
    EXPECT_LT(evaluate(after, {0.5, 0.5, 1}).value.z, center.z - 0.02);
}

TEST(Pressing, AndAsMuchPullingInOneStrokeComesBack)
{
    Press press = press_at({0.4, 0.6, 1, 0.05});
    press.samples.push_back({0.5, 0.6, 0.9, 0.03});
    press.samples.push_back({0.5, 0.6, 0.9, -0.03});
    press.samples.push_back({0.4, 0.6, 1, -0.05});
    EXPECT_LT(farthest(pressed(press), bent_box()), 1e-12);
}

TEST(Pressing, FromTheSceneLiftsColumnsWhichKeepTheirHeight)
{
    const Lattice before = bent_box(), after = pressed(press_at({0.5, 0.5, 0, 0.1}));
    EXPECT_GT(evaluate(after, {0.5, 0.5, 0}).value.z, evaluate(before, {0.5, 0.5, 0}).value.z);
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 1; k < 5; ++k)
                EXPECT_NEAR(
                    glm::distance(control_point(after, i, j, k), control_point(after, i, j, 0)),
                    glm::distance(control_point(before, i, j, k), control_point(before, i, j, 0)),
                    1e-15);
}

TEST(Pressing, UnguardedTooGoesNoDeeperThanTheSceneUnlessItIsAllowed)
{
    Press press = press_at({0.5, 0.5, 1, 3});
    press.decay = Decay::box;
    press.radius = 10;
    press.guard = false;
    const Lattice before = bent_box();
    const auto lowest = [](const Lattice& volume) {
        double least = 1e300;
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 8; ++j)
                for (int k = 0; k < 5; ++k)
                    least = std::min(least, control_point(volume, i, j, k).z);
        return least;
    };
    EXPECT_GE(lowest(pressed(press)), lowest(before) - 1e-9);
    press.into_scene = true;
    EXPECT_LT(lowest(pressed(press)), lowest(before) - 1);
}

TEST(Pressing, AVolumeTurnedInsideOutIsBadEverywhere)
{
    Lattice mirrored = bent_box();
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 5; ++k) {
                const auto at = mirrored.displacement.index(i, j, k);
                mirrored.displacement.points[at].z -= 2 * control_point(mirrored, i, j, k).z;
            }
    EXPECT_TRUE(judge(mirrored).good()) << "it has one sign";
    const CellVerdicts verdicts = *laid_volume(mirrored, 0).verdicts;
    EXPECT_EQ(std::ranges::count(verdicts.of, Verdict::proven_bad), std::ssize(verdicts.of));
}

TEST(Pressing, DrawsNothingIntoTheSceneUnlessItIsAllowed)
{
    Press press = press_at({0.5, 0.5, 0, -0.1});
    EXPECT_EQ(pressed(press), bent_box());
    press.into_scene = true;
    EXPECT_LT(evaluate(pressed(press), {0.5, 0.5, 0}).value.z,
              evaluate(bent_box(), {0.5, 0.5, 0}).value.z);
    press.into_scene = false;
    press.samples = {{0.5, 0.5, 0, 0.02}, {0.5, 0.5, 0, -0.1}}; // down again, but no deeper
    EXPECT_LT(farthest(pressed(press), bent_box()), 1e-12);
}

TEST(Pressing, MirroredIsTheSameOnBothSides)
{
    for (const Decay kind : {Decay::gaussian, Decay::box}) {
        Press press = press_at({0.5, 0.8, 1, 0.05}, kind);
        press.mirror = true;
        const Lattice after = pressed(press);
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 8; ++j)
                for (int k = 0; k < 5; ++k)
                    EXPECT_NEAR(control_point(after, i, j, k).z,
                                control_point(after, i, 7 - j, k).z, 1e-14);
    }
}

TEST(Pressing, WithTheGuardStopsShortOfFolding)
{
    for (const Decay kind : {Decay::gaussian, Decay::hat, Decay::box, Decay::smooth})
        for (const glm::dvec4 sample :
             {glm::dvec4(0.5, 0.5, 1, 3), {0.5, 0.5, 0.5, -3}, {0.3, 0.2, 0, 3}, {0, 0, 1, 3}}) {
            const Press press = press_at(sample, kind);
            EXPECT_EQ(testing::verdict_of(pressed(press)), Verdict::proven_good);
        }
    Press unguarded = press_at({0.5, 0.5, 1, 3});
    unguarded.guard = false;
    EXPECT_EQ(testing::verdict_of(pressed(unguarded)), Verdict::proven_bad);
}

Ref<Placement> placed_box()
{
    Lattice box = bent_box();
    Placement out{Surface<glm::dvec3>{{box.displacement.axes[0], box.displacement.axes[1]}, {}},
                  box,
                  {},
                  {},
                  {},
                  0,
                  0,
                  {}};
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 8; ++j) out.contact.points.push_back(control_point(box, i, j, 0));
    return make_ref(std::move(out));
}
Ref<VolumeEdit> press_edit(std::vector<glm::dvec4> samples)
{
    VolumeEdit edit{.press = press_at({})};
    edit.press->samples = std::move(samples);
    return make_ref(std::move(edit));
}

TEST(Shaper, GivesTheSameBitsStepByStepAndAtOnce)
{
    const Ref<Placement> laid = placed_box();
    const std::vector<glm::dvec4> samples{
        {0.3, 0.5, 1, 0.05}, {0.4, 0.5, 1, 1.3}, {0.5, 0.4, 1, 0.1}};
    const auto shift = make_ref(
        VolumeEdit{.shift = PointShift{.points = {{5, 4, 4}, {6, 4, 4}}, .by = {0, 0.02, 0.1}}});
    Shaper live, at_once;
    for (std::size_t n = 1; n <= samples.size(); ++n)
        live(laid, {shift, press_edit({samples.begin(), samples.begin() + static_cast<long>(n)})});
    live(laid, {shift}); // undone
    const auto a = live(laid, {shift, press_edit(samples)});
    const auto b = at_once(laid, {shift, press_edit(samples)});
    EXPECT_EQ(a->placement->volume, b->placement->volume);
    EXPECT_EQ(a->steps[1].done, b->steps[1].done);
    EXPECT_LT(a->steps[1].done, a->steps[1].asked);
    EXPECT_EQ(live(laid, {})->placement, laid);
}

TEST(Shaper, GoesOnWhereItWasStopped)
{
    const Ref<Placement> laid = placed_box();
    const auto one = press_edit({{0.3, 0.5, 1, 0.05}}), two = press_edit({{0.6, 0.5, 1, 0.05}}),
               three = press_edit({{0.5, 0.4, 1, 0.02}, {0.5, 0.6, 1, 0.02}});
    Shaper shaper;
    shaper(laid, {one, two});
    double last = 0;
    const Progress stop = [&](double fraction, std::string_view) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1);
        if ((last = fraction) > 0.6) throw Cancelled();
    };
    EXPECT_THROW(shaper(laid, {one, three}, stop), Cancelled);
    EXPECT_EQ(shaper(laid, {one})->placement->volume, Shaper()(laid, {one})->placement->volume);
    EXPECT_EQ(shaper(laid, {one, three})->placement->volume,
              Shaper()(laid, {one, three})->placement->volume);
}

TEST(Shaper, RemembersFewVolumesAndGivesTheSameOnTheWayBack)
{
    const Ref<Placement> laid = placed_box();
    std::vector<Ref<VolumeEdit>> steps;
    Shaper live;
    std::map<std::size_t, Lattice> on_the_way;
    const auto after = [&] { return live(laid, steps)->placement->volume; };
    const auto few = [&] { return 1 + 2 * std::log2(static_cast<double>(steps.size())); };
    for (int i = 0; i < 200; ++i) {
        steps.push_back(press_edit({{0.005 * i, 0.5, 1, i % 2 == 0 ? 0.01 : -0.01}}));
        on_the_way.emplace(steps.size(), after());
        EXPECT_LE(static_cast<double>(live.remembered()), few());
    }
    while (steps.size() > 1) {
        steps.pop_back();
        EXPECT_EQ(after(), on_the_way.at(steps.size()));
        EXPECT_LE(static_cast<double>(live.remembered()), few());
    }
}

TEST(Shaper, MendsNothingWhereItMayFold)
{
    VolumeEdit fold{.shift = PointShift{.points = {{5, 4, 4}}, .by = {0, 0, -1}}};
    fold.shift->guard = false;
    const auto folded = make_ref(fold), mended = make_ref(VolumeEdit{.mending = Mending{}}),
               allowed = make_ref(VolumeEdit{.allowance = FoldAllowance{{{{0, 0, 0}, {1, 1, 1}}}}});
    Shaper shaper;
    const Lattice as_folded = shaper(placed_box(), {folded})->placement->volume;
    EXPECT_FALSE(judge(as_folded).good());
    const auto after = shaper(placed_box(), {folded, allowed, mended});
    EXPECT_EQ(after->placement->volume, as_folded);
    EXPECT_TRUE((*after->volume->verdicts).good());
    EXPECT_FALSE(shaper(placed_box(), {folded, mended})->placement->volume == as_folded);
}

TEST(Pressing, BesideALayerThatStaysIsNotStoppedByIt)
{
    const std::array<Knots, 3> axes{Knots::uniform(3, 12), Knots::uniform(3, 8),
                                    Knots::uniform(3, 5)};
    const Lattice box =
        lattice_at_rest(axes, glm::dmat4(2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1));
    const double level = axes[2].greville(2); // lies on the scene, in the middle of the ball
    Press press = press_at({0.5, 0, level, 0.01});
    Pressing pressing(laid_volume(box, level), press);
    const Pressing::BallMotion came = pressing.add(press.samples.front());
    EXPECT_FALSE(came.would_fold);
    EXPECT_NEAR(came.metres, 0.01, 1e-12);
}

TEST(Shaper, InsertsControlPointsWithoutAChange)
{
    const auto finer =
        make_ref(VolumeEdit{.insertion = KnotInsertion{.along = {0.31, 0.55, 0.55}}});
    Shaper shaper;
    const auto after = shaper(placed_box(), {finer});
    EXPECT_EQ(after->placement->volume.displacement.axes[0].count(), 15);
    EXPECT_EQ(after->volume->as_laid->displacement.axes[0].count(), 15);
    for (double u = 0; u <= 1; u += 0.0625)
        EXPECT_LT(glm::distance(evaluate(after->placement->volume, {u, 0.4, 0.7}).value,
                                evaluate(bent_box(), {u, 0.4, 0.7}).value),
                  1e-12);
}

TEST(Shaper, MovesTheContactSurfaceWithTheVolume)
{
    Shaper shaper;
    const auto after = shaper(placed_box(), {press_edit({{0.5, 0.5, 0, 0.1}})});
    const glm::dvec3 on_volume = evaluate(after->placement->volume, {0.5, 0.5, 0}).value;
    EXPECT_LT(glm::distance(evaluate(after->placement->contact, {0.5, 0.5}).value, on_volume),
              1e-12);
    EXPECT_GT(on_volume.z, evaluate(bent_box(), {0.5, 0.5, 0}).value.z + 0.05);
}

TEST(Shaper, PassesOverAStepThatDoesNotFitAndSaysSo)
{
    const auto beyond =
        make_ref(VolumeEdit{.shift = PointShift{.points = {{50, 0, 0}}, .by = {0, 0, 1}}});
    Shaper shaper;
    const auto after = shaper(placed_box(), {beyond, press_edit({{0.5, 0.5, 1, 0.05}})});
    EXPECT_FALSE(after->steps[0].notice.empty());
    EXPECT_TRUE(after->steps[1].notice.empty());
    EXPECT_EQ(after->placement->volume, pressed(press_at({0.5, 0.5, 1, 0.05})));
}

TEST(Shaper, MovesNoOtherPointsThanThoseThatWereMeant)
{
    const auto shift = make_ref(VolumeEdit{
        .shift = PointShift{.points = {{11, 4, 4}}, .by = {0, 0, 0.05}, .of = {12, 8, 5}}});
    const auto finer = make_ref(VolumeEdit{.insertion = KnotInsertion{.along = {0.31}}});
    Shaper shaper;
    EXPECT_TRUE(shaper(placed_box(), {shift, finer})->steps[0].notice.empty());
    const auto after = shaper(placed_box(), {finer, shift}); // another one has that number there
    EXPECT_FALSE(after->steps[1].notice.empty());
    EXPECT_EQ(after->placement->volume, shaper(placed_box(), {finer})->placement->volume);
}

TEST(Shaper, MovesMirroredPointsTheOtherWayAcross)
{
    const auto both = make_ref(VolumeEdit{
        .shift = PointShift{.points = {{5, 7, 4}}, .by = {0, 0.1, 0.05}, .mirror = true}});
    Shaper shaper;
    const Lattice after = shaper(placed_box(), {both})->placement->volume, before = bent_box();
    const glm::dvec3 one = control_point(after, 5, 7, 4) - control_point(before, 5, 7, 4);
    const glm::dvec3 other = control_point(after, 5, 0, 4) - control_point(before, 5, 0, 4);
    EXPECT_NEAR(one.y, 0.1, 1e-12);
    EXPECT_NEAR(other.y, -0.1, 1e-12);
    EXPECT_NEAR(one.z, other.z, 1e-12);
}

TEST(Shaper, MendsWhatFoldsAndLeavesWhatDoesNot)
{
    VolumeEdit fold{.press = press_at({0.5, 0.5, 1, 1})};
    fold.press->guard = false;
    const auto mend = make_ref(VolumeEdit{.mending = Mending{}});
    Shaper shaper;
    const auto folded = shaper(placed_box(), {make_ref(fold)});
    EXPECT_EQ(testing::verdict_of(folded->placement->volume), Verdict::proven_bad);
    const auto after = shaper(placed_box(), {make_ref(fold), mend});
    EXPECT_EQ(testing::verdict_of(after->placement->volume), Verdict::proven_good);
    EXPECT_GT(after->steps[1].done, 0);
    const auto nothing = shaper(placed_box(), {mend});
    EXPECT_EQ(nothing->placement->volume, bent_box());
    EXPECT_EQ(nothing->steps[0].words, "nothing folded");
}

TEST(Shaper, LeavesFewerControlPointsNoFurtherOffThanItSays)
{
    const auto fewer = make_ref(VolumeEdit{.coarsening = Coarsening{VolumeAxis::along, 7}});
    Shaper shaper;
    const auto after = shaper(placed_box(), {fewer});
    EXPECT_EQ(after->placement->volume.displacement.axes[0].count(), 7);
    double most = 0;
    for (double u = 0; u <= 1; u += 1.0 / 256)
        most = std::max(most, glm::distance(evaluate(after->placement->volume, {u, 0.5, 0.5}).value,
                                            evaluate(bent_box(), {u, 0.5, 0.5}).value));
    EXPECT_GT(most, 0);
    EXPECT_LE(most, after->steps[0].done);
    const auto more = make_ref(VolumeEdit{.coarsening = Coarsening{VolumeAxis::along, 70}});
    EXPECT_FALSE(shaper(placed_box(), {more})->steps[0].notice.empty());
}

TEST(Shaper, MovesARowAcrossTheMiddleApartOnBothSides)
{
    const auto row = make_ref(
        VolumeEdit{.shift = PointShift{.points = {{5, 0, 4}, {5, 3, 4}, {5, 4, 4}, {5, 7, 4}},
                                       .by = {0, -0.02, 0},
                                       .mirror = true}});
    Shaper shaper;
    const Lattice after = shaper(placed_box(), {row})->placement->volume, before = bent_box();
    for (const int j : {0, 3, 4, 7})
        EXPECT_NEAR(control_point(after, 5, j, 4).y - control_point(before, 5, j, 4).y,
                    j < 4 ? -0.02 : 0.02, 1e-12);
}

TEST(Shaper, RefusesKnotsThatWouldTearOrCannotBeJudged)
{
    Shaper shaper;
    std::vector<double> many;
    for (int i = 1; i < 20000; ++i) many.push_back(i / 20000.0);
    for (const KnotInsertion& knots :
         {KnotInsertion{.along = {0.55, 0.55, 0.55}}, KnotInsertion{.up = {1e-12}},
          KnotInsertion{.along = many, .across = {0.33, 0.66}}}) {
        const auto edit = make_ref(VolumeEdit{.insertion = knots});
        const auto after = shaper(placed_box(), {edit});
        EXPECT_FALSE(after->steps[0].notice.empty());
        EXPECT_EQ(after->placement->volume, bent_box());
    }
}

TEST(Press, WithNothingToPressIsRefused)
{
    EXPECT_THROW(check(Press{.radius = 0, .samples = {{0, 0, 0, 1}}}), Rejected);
    EXPECT_THROW(check(Press{}), Rejected);
    EXPECT_THROW(check(press_at({2, 0, 0, 1})), Rejected);
    EXPECT_NO_THROW(check(press_at({1, 0, 0, -1})));
}

} // namespace
} // namespace trivar
