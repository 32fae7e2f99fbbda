// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/walking.h"

#include "core/document/command.h"
#include "core/document/evaluate.h"
#include "core/files/read_model.h"
#include "tests/document/commands.h"
#include "tests/support/fixtures.h"

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

// The slide of the vertices of the soles, in the frames of the evaluated object itself, as a share
// of the stride: the same as the walk says, found in another way.
double seen_slide(const Document& document)
{
    Evaluator evaluate = evaluator_of_files();
    const Ref<EvaluatedObject> first = evaluate(document, 1).objects.at(2);
    const Walk& walk = *first->walk;
    struct Standing {
        bool stands = false;
        glm::dvec3 at{0};
    };
    std::vector<Standing> feet(walk.gait->feet.size());
    const Object& o = object(document, 2);
    const Ref<Model> model = make_ref(read_model(std::get<ImportedFile>(o.source).path));
    std::vector<int> nodes; // with a mesh, in the order of the parts
    for (std::size_t n = 0; n < model->nodes.size(); ++n)
        if (model->nodes[n].mesh >= 0) nodes.push_back(static_cast<int>(n));
    double most = 0;
    for (double frame = 1; frame < 60; frame += 0.5) {
        const Ref<EvaluatedObject> now = evaluate(document, frame).objects.at(2);
        const double seconds = (frame - 1) / document.time.frames_per_second;
        const double gone = now->journey->at(seconds).gone_u;
        const double time = walk.clip_time_s(o.playing, gone);
        for (std::size_t f = 0; f < feet.size(); ++f) {
            const Foot& foot = walk.gait->feet[f];
            glm::dvec3 sum(0);
            for (const Foot::Point& point : foot.sole) {
                const auto part = std::ranges::find(nodes, point.node) - nodes.begin();
                sum += glm::dvec3(
                    now->parts[static_cast<std::size_t>(part)].mesh()->positions[point.vertex]);
            }
            glm::dvec3 at = sum / static_cast<double>(foot.sole.size());
            at.z = 0; // all of these courses are level
            const double phase = (time - walk.gait->begin_s) / walk.gait->period_s - foot.begin;
            const bool stands = phase - std::floor(phase) <= foot.end - foot.begin;
            if (stands && feet[f].stands) most = std::max(most, glm::distance(at, feet[f].at));
            if (!stands || !feet[f].stands) feet[f] = {stands, at};
        }
    }
    return most / (walk.natural_speed * walk.gait->period_s);
}

class Walks : public ::testing::TestWithParam<std::tuple<const char*, Way>> {};

TEST_P(Walks, SlideByHalfAPercentOfTheirStrideAtMost)
{
    const auto& [name, way] = GetParam();
    Course course{std::string(TRIVAR_BINARY_DIR) + "/assets/models/" + name + ".glb", "walk",
                  small_model(LengthAxis::x, false), way};
    if (!std::filesystem::exists(course.path)) GTEST_SKIP() << "the sample models are not made";
    if (way == Way::round) course.travel.ends = Ends::loop;
    const Document document = laid_out(course);
    const Ref<EvaluatedObject> object = evaluator_of_files()(document, 1).objects.at(2);
    ASSERT_TRUE(object->walk);
    EXPECT_EQ(object->walk->trouble, "");
    EXPECT_GT(object->journey->seconds(), 5);
    EXPECT_LT(*object->walk->slide, 0.005);
    EXPECT_LT(seen_slide(document), 0.005);
}

INSTANTIATE_TEST_SUITE_P(SampleModels, Walks,
                         ::testing::Combine(::testing::Values("ant", "robot"),
                                            ::testing::Values(Way::straight, Way::curved,
                                                              Way::round)));

TEST(Walking, SaysThatFeetAreLockedToNothingWhereItLiesOnNoStroke)
{
    const std::string path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/ant.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the sample models are not made";
    const Document document =
        after(laid_out({path, "walk", small_model(LengthAxis::x, false)}), Unplace{2});
    EXPECT_THAT(evaluator_of_files()(document, 1).objects.at(2)->notices,
                Contains("its feet are locked to its travel, and it lies on no stroke"));
    const Document free = after(document, PlayClip{{2}, {.clip = "walk"}});
    EXPECT_TRUE(evaluator_of_files()(free, 1).objects.at(2)->notices.empty());
}

TEST(Walking, SaysThatAModelWhoseFrontIsElsewhereWalksBackwards)
{
    Course course{std::string(TRIVAR_BINARY_DIR) + "/assets/models/ant.glb", "walk",
                  small_model(LengthAxis::x, false)};
    if (!std::filesystem::exists(course.path)) GTEST_SKIP() << "the sample models are not made";
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
    for (const auto& [name, stride] : {std::pair{"ant", 0.17 / 0.55}, {"robot", 0.23 / 0.6}}) {
        const std::string path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/" + name + ".glb";
        if (!std::filesystem::exists(path)) GTEST_SKIP() << "the sample models are not made";
        const Model model = read_model(path);
        const Gait gait = gait_of(model, model.clips.at(0));
        EXPECT_NEAR(gait.stride, stride, 0.005 * stride);
        EXPECT_EQ(gait.feet.size(), name == std::string("ant") ? 6u : 2u);
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
    EXPECT_LT(seen_slide(document), 0.02);
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
                Contains(HasSubstr("in \"Survey\" it moves no foot along the ground")));
}

} // namespace
} // namespace trivar
