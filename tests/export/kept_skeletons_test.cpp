// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/film.h"
#include "core/certificate/film_check.h"
#include "core/certificate/kept_clip.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/stages/walk.h"
#include "core/steps/moving/posing.h"
#include "tests/export/scenes.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

// The rounding of single precision at places of a few metres, and times of a second.
constexpr double single_precision = 1e-5;

class KeptSkeletons : public testing::ExportedScenes {
protected:
    double furthest(const AnimatedExport& made, const Document& document, Id id) const
    {
        const std::vector<FilmSample> found = sampled_film(made, document, assets_, 10);
        double out = 0;
        for (std::size_t p = 0; p < found.size(); ++p)
            if (made.certificate.parts[p].object == id) out = std::max(out, found[p].furthest);
        return out;
    }
    static const Node& named(const Model& model, const std::string& name)
    {
        const auto found = std::ranges::find(model.nodes, name, &Node::name);
        EXPECT_NE(found, model.nodes.end()) << name;
        return *found;
    }
};

// A channel that goes up, down and up by a way, with its first key after the clip begins.
Channel some_channel(Channel::Of of, Channel::Interpolation interpolation)
{
    Channel out{0, of, interpolation, {0.1f, 0.3f, 0.45f, 0.8f}, {}, 3};
    if (of == Channel::Of::rotation) out.components = 4;
    const bool cubic = interpolation == Channel::Interpolation::cubic;
    for (int key = 0; key < 4; ++key)
        for (int part = cubic ? 0 : 1; part < (cubic ? 3 : 2); ++part) {
            const float angle = 0.7f * static_cast<float>(key % 2 + key);
            glm::vec4 v(std::sin(angle), 0, 0, std::cos(angle));
            if (part != 1) v = glm::vec4(1, 0.5f, -0.3f * static_cast<float>(key), 0.2f);
            for (std::size_t i = 0; i < out.components; ++i)
                out.values.push_back(v[static_cast<int>(i)]);
        }
    return out;
}

TEST_F(KeptSkeletons, HaveChannelsThatAreTheClipsOwnHoweverItIsPlayed)
{
    Clip clip{"wave", {}, 0, 0.875};
    const std::vector<double> moments = moments_of({3, 40}, 4);
    for (const Repeat repeat : {Repeat::once, Repeat::loop, Repeat::back_and_forth})
        for (const double speed : {1.0, -0.7, 2.3, 0.0})
            for (const auto of : {Channel::Of::translation, Channel::Of::rotation})
                for (const auto interpolation :
                     {Channel::Interpolation::step, Channel::Interpolation::linear,
                      Channel::Interpolation::cubic}) {
                    const Document document = playing(still_, {.clip = "wave",
                                                               .speed = speed,
                                                               .repeat = repeat,
                                                               .offset = 0.2,
                                                               .start_frame = 6});
                    const Channel channel = some_channel(of, interpolation);
                    const Channel kept = played(channel, played_time(document, 5, clip, moments));
                    EXPECT_EQ(kept.interpolation, interpolation);
                    EXPECT_EQ(kept.times_s.front(), 0);
                    EXPECT_NEAR(kept.times_s.back(), speed == 0 ? kept.times_s.back() : 37.0 / 12,
                                interpolation == Channel::Interpolation::step ? 10 : 1e-6);
                    const Playing& playing = object(document, 5).playing;
                    for (int i = 0; i <= 997; ++i) {
                        const double film_s = 37.0 / 12 * i / 997, since = film_s - 3.0 / 12;
                        const std::vector<double> shown = value_at(kept, film_s),
                                                  meant = value_at(
                                                      channel, clip_time_s(clip, playing, since));
                        double dot = 0; // a rotation has two signs
                        for (std::size_t c = 0; c < shown.size(); ++c) dot += shown[c] * meant[c];
                        const double sign = of == Channel::Of::rotation && dot < 0 ? -1 : 1;
                        for (std::size_t c = 0; c < shown.size(); ++c)
                            ASSERT_NEAR(sign * shown[c], meant[c], 2e-5)
                                << int(repeat) << " " << speed << " " << int(of) << " "
                                << int(interpolation) << " at " << film_s;
                    }
                }
}

TEST_F(KeptSkeletons, AreTheSourcesBonesByNameBelowEachOther)
{
    const Document document = playing(still_, {.clip = "bend", .speed = 1.7, .offset = 0.1});
    const AnimatedExport made = exported(document);
    const Model& model = made.model;
    const Node &root = named(model, "root"), &tip = named(model, "tip");
    EXPECT_EQ(&model.nodes[static_cast<std::size_t>(tip.parent)], &root);
    EXPECT_EQ(model.nodes[static_cast<std::size_t>(root.parent)].name, "Bar");
    EXPECT_EQ(tip.rest.translation, glm::dvec3(2, 0, 0)); // of its parent's units, not of the scene
    ASSERT_EQ(model.skins.size(), 1u);
    EXPECT_EQ(model.skins.front().joints.size(), 2u);
    ASSERT_EQ(model.clips.size(), 1u);
    ASSERT_EQ(model.clips.front().channels.size(), 1u);
    const Channel& turn = model.clips.front().channels.front();
    EXPECT_EQ(&model.nodes[static_cast<std::size_t>(turn.node)], &tip);
    EXPECT_EQ(turn.of, Channel::Of::rotation);
    EXPECT_LE(turn.times_s.size(), 4u); // it begins within the clip, which begins anew once
    EXPECT_LT(furthest(made, document, 5), single_precision);
}

TEST_F(KeptSkeletons, AreWhereTheSceneHasThemWhileTheirObjectMovesAndTurns)
{
    Document document = playing(still_, {.clip = "bend", .repeat = Repeat::back_and_forth});
    document = keyed(document, 5, "transform.translation.x",
                     {{.frame = 1, .value = 0}, {.frame = 7, .value = 0.5}});
    const AnimatedExport made = exported(document);
    EXPECT_EQ(made.certificate.parts.size(), 4u);
    EXPECT_LE(furthest(made, document, 5), made.certificate.tolerance);
    EXPECT_LE(made.certificate.bound, made.certificate.tolerance);
}

TEST_F(KeptSkeletons, OfWhatIsHiddenShrinkWithIt)
{
    Document document = playing(still_, {.clip = "bend"});
    document = keyed(document, 5, "hidden",
                     {{.frame = 1, .value = 0, .tween = Tween::step},
                      {.frame = 4, .value = 1, .tween = Tween::step}});
    const Model model = exported(document).model;
    const Stance late = stance_at(model, &model.clips.front(), 0.45);
    for (const int joint : model.skins.front().joints)
        EXPECT_EQ(late.to_model[static_cast<std::size_t>(joint)][0], glm::dvec4(0));
}

TEST_F(KeptSkeletons, StandAsTheyAreInASingleFrame)
{
    Document document = playing(still_, {.clip = "bend", .offset = 0.5});
    document.time.last_frame = 1;
    EXPECT_LT(furthest(exported(document), document, 5), single_precision);
}

TEST_F(KeptSkeletons, ArePlayedByMomentsWhereTheirPlaceInTheClipHasKeys)
{
    const Document document =
        keyed(playing(still_, {.clip = "bend", .speed = 0}), 5, "playing.offset",
              {{.frame = 1, .value = 0}, {.frame = 7, .value = 0.9}});
    const AnimatedExport made = exported(document);
    EXPECT_LE(furthest(made, document, 5), made.certificate.tolerance);
}

TEST_F(KeptSkeletons, ArePlayedByMomentsWhereTheirLapsCannotBeCounted)
{
    const Clip clip{"wave", {}, 0, 1e-12};
    for (const Repeat repeat : {Repeat::loop, Repeat::back_and_forth})
        for (const double offset : {1e6, -1e6}) {
            const Document document = playing(
                still_, {.clip = "wave", .speed = 1e-12, .repeat = repeat, .offset = offset});
            const PlayedTime time = played_time(document, 5, clip, moments_of({1, 7}, 1));
            EXPECT_TRUE(time.by_moments);
            EXPECT_EQ(time.pieces.size(), 6u);
        }
}

TEST_F(KeptSkeletons, ComeBackFromTheirFile)
{
    const Document document = playing(still_, {.clip = "bend"});
    write_model(exported(document).model, folder_.file("a.glb"));
    const Model read = read_model(folder_.file("a.glb"));
    const Node& bar = named(read, "bar"); // where a skinned mesh hangs counts for nothing
    EXPECT_EQ(bar.parent, -1);
    EXPECT_GE(bar.skin, 0);
    const Node& tip = named(read, "tip");
    EXPECT_EQ(read.nodes[static_cast<std::size_t>(tip.parent)].name, "root");
    Document again;
    ImportModel import;
    import.file.path = "a.glb";
    again.time = document.time;
    again = after(again, import);
    again = after(again, PlayClip{{1}, {.clip = "Scene", .repeat = Repeat::once}});
    Evaluator evaluate(assets_);
    const auto bar_of = [](const EvaluatedObject& object) {
        std::size_t most = 0;
        for (std::size_t p = 0; p < object.parts.size(); ++p)
            if (object.parts[p].posed) most = p;
        return object.parts[most];
    };
    for (const double frame : {1.0, 3.3, 6.0}) {
        const Part there = bar_of(*evaluate(document, frame).objects.at(5)),
                   here = bar_of(*evaluate(again, frame).objects.at(1));
        const Box a = bounding_box(*there.mesh(), there.to_world),
                  b = bounding_box(*here.mesh(), here.to_world);
        EXPECT_LT(glm::distance(a.lo, b.lo) + glm::distance(a.hi, b.hi), single_precision);
    }
}

class RealDataSkeletons : public KeptSkeletons {};

TEST_F(RealDataSkeletons, OfTheFoxAreExportedBoneByBone)
{
    const std::string folder = testing::real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    Document document;
    document.time = {.first_frame = 1, .last_frame = 25};
    ImportModel import;
    import.file.path = folder + "/animated/Fox.glb";
    import.file.scale = 0.01;
    document = after(document, import);
    document = after(document, PlayClip{{1}, {.clip = "Walk", .speed = 1.3}});
    const AnimatedExport made = exported(document);
    const Model source = read_model(import.file.path);
    const std::vector<int>& joints = made.model.skins.at(0).joints;
    ASSERT_EQ(joints.size(), source.skins.at(0).joints.size());
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Node &bone = made.model.nodes[static_cast<std::size_t>(joints[j])],
                   &own = source.nodes[static_cast<std::size_t>(source.skins[0].joints[j])];
        EXPECT_EQ(bone.name, own.name);
        EXPECT_EQ(made.model.nodes[static_cast<std::size_t>(bone.parent)].name,
                  source.nodes[static_cast<std::size_t>(own.parent)].name);
    }
    EXPECT_EQ(made.model.clips.at(0).channels.size(), source.clips.at(1).channels.size());
    EXPECT_LT(furthest(made, document, 1), single_precision);
}

} // namespace
} // namespace trivar
