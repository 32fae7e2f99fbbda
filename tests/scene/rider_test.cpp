// SPDX-License-Identifier: GPL-3.0-or-later
// A crocodile 3 on the back of a horse 2 that walks over hills 1, in assets/scenes/rider.trivar.
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/play.h"
#include "core/commands/placement/place.h"
#include "core/placement/placement.h"
#include "core/scene/log.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/lying.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::IsEmpty;

constexpr Id ridden = 2, riding = 3;
const std::string rider_folder = TRIVAR_SOURCE_DIR "/assets/scenes";

Document rider_scene()
{
    const std::string path = rider_folder + "/rider.trivar";
    return replay(read_log(read_text_file(path), path)).document();
}

// With the models as this build made them.
Evaluator rider_evaluator()
{
    std::map<std::string, std::string> models;
    for (const auto& entry :
         std::filesystem::directory_iterator(TRIVAR_BINARY_DIR "/assets/models"))
        models[entry.path().filename()] = entry.path();
    return Evaluator(std::make_shared<const AssetStore>(rider_folder, models));
}

bool shot_rays(const Evaluation& evaluated)
{
    return std::ranges::any_of(evaluated.timings.stages,
                               [](const auto& stage) { return stage.name == "rays"; });
}

// Places of the contact under the middle of the crocodile, from its tail to its head, on the horse.
std::vector<testing::NearestPlace> places_on_the_horse(const Evaluation& now)
{
    const testing::NearestOn on(*now.objects.at(ridden));
    std::vector<testing::NearestPlace> out;
    for (const double u : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95})
        out.push_back(on(evaluate(now.objects.at(riding)->placement->contact, {u, 0.5}).value));
    return out;
}

// The horse is a metre long.
TEST(Rider, StaysOnItsPlaceOnTheBackInEveryFrame)
{
    constexpr double off_the_back = 0.004, off_at_its_ends = 0.013,
                     along_the_back = 0.012; // metres
    const Document document = rider_scene();
    Evaluator evaluate = rider_evaluator();
    const Evaluation first = evaluate(document, 1);
    const std::vector<testing::NearestPlace> drawn = places_on_the_horse(first);
    for (double frame = 1; frame <= 240; frame += 8.5) {
        const Evaluation now = evaluate(document, frame);
        const EvaluatedObject& laid = *now.objects.at(riding);
        ASSERT_THAT(laid.rejected, IsEmpty()) << frame;
        EXPECT_THAT(laid.notices, IsEmpty()) << frame;
        EXPECT_LE(laid.placement->report.penetration, 1e-3) << frame;
        const std::vector<testing::NearestPlace> places = places_on_the_horse(now);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool end = i == 0 || i + 1 == places.size(); // over the croup and the withers
            EXPECT_LT(places[i].off, end ? off_at_its_ends : off_the_back)
                << i << " of frame " << frame;
            EXPECT_LT(glm::distance(places[i].rest, drawn[i].rest), along_the_back)
                << i << " of frame " << frame;
        }
    }
    EXPECT_GT(glm::distance(places_on_the_horse(evaluate(document, 240)).front().p_world,
                            drawn.front().p_world),
              3)
        << "while the horse has gone far";
}

TEST(Rider, IsTheSameBitsForAnyNumberOfThreads)
{
    const Document document = rider_scene();
    for (const double frame : {60.0, 137.5}) {
        const std::string expected = digest(rider_evaluator()(document, frame));
        for (const int threads : {1, 2, 8}) {
            const ThreadLimit limit(threads);
            EXPECT_EQ(digest(rider_evaluator()(document, frame)), expected)
                << threads << " threads, frame " << frame;
        }
    }
}

TEST(Rider, DependsOnNoFrameThatWasPlayedBefore)
{
    const Document document = rider_scene();
    Evaluator played = rider_evaluator();
    for (int frame = 1; frame <= 40; ++frame) {
        const Evaluation now = played(document, frame);
        if (frame % 13 == 1) {
            EXPECT_EQ(digest(rider_evaluator()(document, frame)), digest(now)) << frame;
        }
    }
}

// The horse stands still in the pose in which the crocodile was laid.
TEST(Rider, ShootsNoRaysWhileTheHorseIsMovedAsAWhole)
{
    Document document = rider_scene();
    document = after(document, Group{{ridden, riding}, "Both"});
    document = after(document, Unplace{ridden});
    document = after(document, PlayClip{{ridden}, {}});
    const EvaluatedObject stands = *rider_evaluator()(document, 1).objects.at(ridden);
    Sketch sketch;
    sketch.camera.perspective = false;
    sketch.camera.height_world = 2;
    sketch.camera.target = stands.bounds->center();
    sketch.camera.eye = sketch.camera.target + glm::dvec3(0, -1e-3, 3);
    for (int i = 0; i <= 12; ++i) sketch.samples.push_back({{570 + 10 * i, 360}, 0.05 * i, 1});
    document = after(document, EditPlacement{riding, object(document, riding).stroke->parameters,
                                             sketch, std::vector<Id>{ridden}});
    document = after(document, Attach{riding, {}});
    Evaluator evaluate = rider_evaluator();
    const Evaluation first = evaluate(document);
    EXPECT_TRUE(shot_rays(first)) << "what is counted is there";
    ASSERT_THAT(first.objects.at(riding)->rejected, IsEmpty());
    const glm::dmat4 back = glm::inverse(to_world(document, ridden));
    for (const Transform& t : std::initializer_list<Transform>{
             {.translation = {1, -2, 0.25}},
             {.translation = {3, 0, 1}, .rotation_deg = {20, -35, 140}},
             {.rotation_deg = {0, 0, 30}, .scale = {2.5, 2.5, 2.5}}}) {
        const Document moved = after(document, SetTransform{ridden, t});
        const Evaluation now = evaluate(moved);
        EXPECT_FALSE(shot_rays(now));
        EXPECT_LT(testing::furthest_off(testing::world_points(*now.objects.at(riding)),
                                        testing::world_points(*first.objects.at(riding)),
                                        to_world(moved, ridden) * back),
                  1e-6);
    }
    EXPECT_TRUE(shot_rays(evaluate(after(document, SetTransform{ridden, {.scale = {1, 1, 2}}}))));
}

} // namespace
} // namespace trivar
