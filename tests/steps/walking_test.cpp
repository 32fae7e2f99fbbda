// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/steps/moving/walks.h"

#include "core/commands/command.h"
#include "core/evaluation/evaluate.h"
#include "core/files/read_model.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::HasSubstr, ::testing::Not;
using testing::real_data_folder;

enum class Way { straight, curved, round };

// A model as object 2, laid along a stroke on a large table or round a ring, walking.
struct Course {
    std::string path, clip;
    PlacementParameters parameters;
    Way way = Way::straight;
    Travel travel{.speed = 0.2};
};

Evaluator evaluator_of_files()
{
    return Evaluator(std::make_shared<const AssetStore>("/"));
}

Document laid_out(const Course& course, bool foot_lock = true)
{
    ImportModel import;
    import.file.path = std::filesystem::absolute(course.path).string();
    Document document;
    PlacementParameters p = course.parameters;
    if (course.way == Way::round) {
        document = after(
            after(document, AddTorus{.name = "Ring", .shape = {1, 0.3, {96, 48}}, .transform = {}}),
            import);
        document = after(document, PlaceRound{2, 1, 0.3, p});
    } else {
        document = after(
            after(document, AddBox{.name = "Table", .shape = {.size = {8, 8, 1}}, .transform = {}}),
            import);
        Sketch sketch;
        sketch.camera.eye = {0, -4, 8};
        for (int i = 0; i <= 20; ++i) {
            const double t = i / 20.0, x = 200 + 800 * t;
            const double y =
                course.way == Way::curved ? 400 + 120 * std::sin(6.283185307 * t) : 400 + 20 * t;
            sketch.samples.push_back({{x, y}, 0.1 * i, 1});
        }
        document = after(document, Place{2, sketch, p, {1}});
    }
    document = after(document, SetTravel{{2}, course.travel});
    return after(document, PlayClip{{2}, {.clip = course.clip, .foot_lock = foot_lock}});
}

PlacementParameters small_model(LengthAxis along, bool reverse)
{
    PlacementParameters p;
    p.fill = 0.1;
    p.along = along;
    p.reverse = reverse;
    return p;
}

// How far what touches the ground goes over it while it does, as a share of the stride: of every
// vertex of the evaluated object, from the sample in which it comes within `touching` of the
// object's height over the ground to the last before it is higher, the largest distance between any
// two places, through two periods. Nothing is asked of the gait but how long its period is.
struct Contacts {
    double slide = 0, lowest = 0; // the latter: metres over the table
    int count = 0;
};
constexpr double touching = 2e-3;

Contacts contacts_of(const Document& document)
{
    constexpr int samples_a_period = 125, samples = 2 * samples_a_period;
    Evaluator evaluate = evaluator_of_files();
    const Evaluation first = evaluate(document, 1);
    const Walk& walk = *first.objects.at(2)->walk;
    const double stride = walk.natural_speed * walk.gait->period_s;
    const double frames = stride / std::abs(object(document, 2).travel.speed) *
                          document.time.frames_per_second / samples_a_period;
    const auto positions = [&](int sample) {
        std::vector<glm::dvec3> out;
        for (const Part& part : evaluate(document, 1 + frames * sample).objects.at(2)->parts)
            out.insert(out.end(), part.mesh()->positions.begin(), part.mesh()->positions.end());
        return out;
    };
    const double table = bounding_box(*first.objects.at(1)->parts[0].mesh()).hi.z;
    Box box;
    for (const glm::dvec3& p : positions(0)) box.add(p);
    Contacts out;
    out.lowest = box.hi.z;
    std::vector<std::vector<glm::dvec2>> runs(positions(0).size());
    for (int i = 0; i <= samples; ++i) {
        const std::vector<glm::dvec3> now = positions(i);
        for (std::size_t v = 0; v < now.size(); ++v) {
            out.lowest = std::min(out.lowest, now[v].z - table);
            if (now[v].z - table > touching * box.size().z) {
                runs[v].clear();
                continue;
            }
            if (runs[v].empty()) ++out.count;
            for (const glm::dvec2& before : runs[v])
                out.slide = std::max(out.slide, glm::distance(before, glm::dvec2(now[v])) / stride);
            runs[v].emplace_back(now[v]);
        }
    }
    return out;
}

class Walks : public ::testing::TestWithParam<std::tuple<const char*, Way>> {};

TEST_P(Walks, SlideByHalfAPercentOfTheirStrideAtMost)
{
    const auto& [name, way] = GetParam();
    Course course{std::string(TRIVAR_BINARY_DIR) + "/assets/models/" + name + ".glb", "walk",
                  small_model(LengthAxis::x, false), way};
    ASSERT_TRUE(std::filesystem::exists(course.path));
    if (way == Way::round) course.travel.ends = Ends::loop;
    const Document document = laid_out(course);
    const Ref<EvaluatedObject> object = evaluator_of_files()(document, 1).objects.at(2);
    ASSERT_TRUE(object->walk);
    EXPECT_EQ(object->walk->trouble, "");
    EXPECT_GT(object->journey->seconds(), 5);
    EXPECT_LT(*object->walk->slide, 0.005);
    if (way == Way::round) return; // its ground is not level
    const Contacts seen = contacts_of(document);
    EXPECT_LT(seen.slide, 0.005);
    EXPECT_NEAR(seen.lowest, 0, 1e-3);
    EXPECT_GT(seen.count, 10);
}

INSTANTIATE_TEST_SUITE_P(SampleModels, Walks,
                         ::testing::Combine(::testing::Values("ant", "robot"),
                                            ::testing::Values(Way::straight, Way::curved,
                                                              Way::round)));

INSTANTIATE_TEST_SUITE_P(TheHorse, Walks,
                         ::testing::Combine(::testing::Values("horse"),
                                            ::testing::Values(Way::straight)));

TEST(Walking, SaysThatFeetAreLockedToNothingWhereItLiesOnNoStroke)
{
    const std::string path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/ant.glb";
    ASSERT_TRUE(std::filesystem::exists(path));
    const Document document =
        after(laid_out({path, "walk", small_model(LengthAxis::x, false)}), Unplace{2});
    EXPECT_THAT(evaluator_of_files()(document, 1).objects.at(2)->notices,
                Contains("foot lock has no effect without a stroke; place the object on one"));
    const Document free = after(document, PlayClip{{2}, {.clip = "walk"}});
    EXPECT_TRUE(evaluator_of_files()(free, 1).objects.at(2)->notices.empty());
}

TEST(Walking, SaysThatAModelWhoseFrontIsElsewhereWalksBackwards)
{
    Course course{std::string(TRIVAR_BINARY_DIR) + "/assets/models/ant.glb", "walk",
                  small_model(LengthAxis::x, false)};
    ASSERT_TRUE(std::filesystem::exists(course.path));
    const auto notices = [&](double turned_deg, double speed) {
        course.travel.speed = speed;
        Transform transform;
        transform.rotation_deg.z = turned_deg;
        return evaluator_of_files()(after(laid_out(course), SetTransform{2, transform}), 1)
            .objects.at(2)
            ->notices;
    };
    const auto backwards = Contains(HasSubstr("it walks backwards"));
    EXPECT_THAT(notices(180, 0.2), backwards);
    EXPECT_THAT(notices(180, -0.2), Not(backwards));
    EXPECT_THAT(notices(0, 0.2), Not(backwards));
    EXPECT_THAT(notices(0, -0.2), Not(backwards)) << "that is meant";
}

TEST(Walking, KnowsTheStrideThatTheModelsAreMadeWith)
{
    struct Walker {
        const char* name;
        double stride;
        std::size_t feet;
    };
    for (const auto& [name, stride, feet] :
         {Walker{"ant", 0.17 / 0.55, 6}, {"robot", 0.23 / 0.6, 2}, {"horse", 0.28 / 0.64, 4}}) {
        const std::string path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/" + name + ".glb";
        ASSERT_TRUE(std::filesystem::exists(path));
        const Model model = read_model(path);
        const Gait gait = gait_of(model, model.clips.at(0));
        EXPECT_NEAR(gait.stride, stride, 0.005 * stride);
        EXPECT_EQ(gait.feet.size(), feet) << name;
        EXPECT_LT(glm::distance(gait.forward, {1, 0, 0}), 0.005);
    }
}

class RealDataWalks : public ::testing::TestWithParam<std::tuple<const char*, Way>> {};

TEST_P(RealDataWalks, OfTheFoxSlideByTwoPercentAtMost)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const auto& [clip, way] = GetParam();
    const Course course{real_data_folder() + "/animated/Fox.glb", clip,
                        small_model(LengthAxis::y, true), way};
    const Document document = laid_out(course);
    const Ref<EvaluatedObject> object = evaluator_of_files()(document, 1).objects.at(2);
    ASSERT_TRUE(object->walk);
    EXPECT_EQ(object->walk->trouble, "");
    EXPECT_EQ(object->walk->gait->feet.size(), 4u);
    EXPECT_GT(object->walk->stride_u, 0);
    EXPECT_GT(object->journey->seconds(), 5);
    EXPECT_LT(*object->walk->slide, 0.02);
    const Contacts seen = contacts_of(document);
    EXPECT_LT(seen.slide, 0.02);
    EXPECT_NEAR(seen.lowest, 0, 1e-3);
    EXPECT_GT(seen.count, 10);
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataWalks,
                         ::testing::Combine(::testing::Values("Walk", "Run"),
                                            ::testing::Values(Way::straight, Way::curved)));

TEST(RealDataWalking, SaysThatAFoxThatLooksRoundWalksNowhere)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Document document = laid_out({real_data_folder() + "/animated/Fox.glb", "Survey",
                                        small_model(LengthAxis::y, true), Way::straight});
    EXPECT_THAT(evaluator_of_files()(document, 1).objects.at(2)->notices,
                Contains(HasSubstr("\"Survey\" moves no foot along the ground")));
}

} // namespace
} // namespace trivar
