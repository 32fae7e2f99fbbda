// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/export/scenes.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;
using Claim = FilmCertificate::PartClaim;

class FilmClaims : public testing::ExportedScenes {};

TEST_F(FilmClaims, AreProvenRoundABandThatTwistsWithTwoFollowing)
{
    const Document document = travelling(round(), {.speed = 2, .ends = Ends::loop, .followers = 2});
    const AnimatedExport made = exported(document);
    ASSERT_EQ(of(made, 5).size(), 3u);
    EXPECT_THAT(not_certified(made.certificate), IsEmpty());
    EXPECT_LE(made.certificate.bound, 2e-3);
    expect_holds(document, made);
}

TEST_F(FilmClaims, AreProvenOnAStrokeThatIsProlongedAtBothEnds)
{
    for (const double speed : {1.5, -1.5})
        for (const double start : {0.0, 0.3}) {
            Document document = laid();
            PlacementParameters p = object(document, 5).stroke->parameters;
            p.start = start;
            document = travelling(after(document, EditPlacement{5, p, {}, {}}),
                                  {.speed = speed, .ends = Ends::run_on, .followers = 1});
            const AnimatedExport made = exported(document);
            EXPECT_THAT(not_certified(made.certificate), IsEmpty()) << speed << " " << start;
            expect_holds(document, made, 20);
        }
}

TEST_F(FilmClaims, AreProvenWhereARingBeginsAgain)
{
    Sketch ring;
    ring.camera.eye = {0, -4, 4};
    for (int i = 0; i <= 60; ++i)
        ring.samples.push_back(
            {{640 + 100 * std::cos(i * 0.1047198), 360 + 70 * std::sin(i * 0.1047198)}, 0.1 * i});
    PlacementParameters p;
    p.fill = 0.3;
    const Document still = after(still_, Place{5, ring, p, {1}});
    for (const double speed : {1.5, -1.5})
        for (const int followers : {0, 1}) {
            const Document document =
                travelling(still, {.speed = speed, .ends = Ends::loop, .followers = followers});
            const AnimatedExport made = exported(document, 5e-3);
            EXPECT_THAT(not_certified(made.certificate), IsEmpty()) << speed << " " << followers;
            expect_holds(document, made, 20);
        }
}

TEST_F(FilmClaims, AreProvenWhileASkinBendsInAVolumeAndTravels)
{
    const Document document = playing(travelling(round(), {.speed = 0.4, .ends = Ends::loop}),
                                      {.clip = "bend", .repeat = Repeat::back_and_forth});
    const AnimatedExport made = exported(document, 2e-2);
    EXPECT_EQ(of(made, 5).front().way, "targets");
    EXPECT_THAT(of(made, 5).front().unproven, IsEmpty());
    EXPECT_GT(of(made, 5).front().motion, 0);
    expect_holds(document, made);
}

TEST_F(FilmClaims, AreProvenWhileASkinBendsByACubic)
{
    Model model = testing::rigged_model();
    Channel& turn = model.clips[0].channels.front();
    const std::vector<float> from(turn.values.begin(), turn.values.begin() + 4),
        to(turn.values.begin() + 4, turn.values.end());
    const std::vector<float> slope_from{0, 0, 1.5f, 0}, slope_to{0.1f, 0, -0.4f, 0.3f};
    turn.interpolation = Channel::Interpolation::cubic;
    turn.values.clear();
    for (const auto& part : {slope_from, from, slope_from, slope_to, to, slope_to})
        turn.values.insert(turn.values.end(), part.begin(), part.end());
    testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
    const Document document = playing(travelling(round(), {.speed = 0.4, .ends = Ends::loop}),
                                      {.clip = "bend", .repeat = Repeat::back_and_forth});
    const AnimatedExport made = exported(document, 2e-2);
    EXPECT_THAT(of(made, 5).front().unproven, IsEmpty());
    EXPECT_GT(of(made, 5).front().motion, 0);
    expect_holds(document, made);
}

TEST_F(FilmClaims, AreProvenBeyondTheEndOfAClipThatIsPlayedOnce)
{
    for (const bool steps : {false, true}) {
        Model model = testing::rigged_model();
        if (steps) { // stands at its last key as it does nowhere before
            Channel& turn = model.clips[0].channels.front();
            turn.interpolation = Channel::Interpolation::step;
        }
        testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
        const Document document =
            playing(travelling(round(), {.speed = 0.4, .ends = Ends::loop}),
                    {.clip = "bend", .speed = 3.7, .repeat = Repeat::once}); // ends in a frame
        const AnimatedExport made = exported(document, 2e-2);
        EXPECT_THAT(of(made, 5).front().unproven, IsEmpty());
        expect_holds(document, made);
        Document late = document;
        late.time.first_frame = 5;
        const AnimatedExport held = animated_export({late, {5, 7}, 2e-2, "a.trivar"}, assets_);
        EXPECT_THAT(of(held, 5).front().unproven, IsEmpty());
        EXPECT_LT(of(held, 5).front().motion, 2e-3); // by travel alone
        expect_holds(late, held);
    }
}

TEST_F(FilmClaims, AreProvenWhileMorphTargetsSwellInAVolume)
{
    Model model = testing::rigged_model();
    Clip both = model.clips[0];
    both.name = "both";
    both.channels.push_back(model.clips[1].channels.front());
    model.clips.push_back(both);
    testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
    for (const char* clip : {"swell", "both"})
        for (const double speed : {0.0, 0.4}) {
            const Document document =
                playing(travelling(round(), {.speed = speed, .ends = Ends::loop}),
                        {.clip = clip, .speed = 1.3, .repeat = Repeat::back_and_forth});
            const AnimatedExport made = exported(document, 2e-2);
            EXPECT_THAT(of(made, 5).front().unproven, IsEmpty()) << clip;
            EXPECT_GT(of(made, 5).front().motion, 0) << clip;
            EXPECT_LE(made.certificate.bound, 2e-2) << clip;
            expect_holds(document, made);
        }
}

TEST_F(FilmClaims, SayWhatIsNotProven)
{
    const Document width = keyed(laid(), 5, "placement.width",
                                 {{.frame = 1, .value = 0.4}, {.frame = 7, .value = 0.6}});
    const AnimatedExport made = exported(width);
    EXPECT_THAT(of(made, 5).front().unproven, HasSubstr("placement.width has keys"));
    EXPECT_THAT(not_certified(made.certificate), ::testing::Not(IsEmpty()));
    expect_holds(width, made);
    const Document lower = keyed(laid(), 1, "transform.translation.z",
                                 {{.frame = 1, .value = 0}, {.frame = 7, .value = 0.2}});
    EXPECT_THAT(of(exported(lower), 5).front().unproven, HasSubstr("what it lies on"));
}

TEST_F(FilmClaims, SayThatNothingIsKnownOfAClipThatGoesRoundVeryOften)
{
    // A bar that swells and shrinks: 2048 times in each frame, so often that each is as the one
    // before; and 1e18 times before the first one.
    Model model = testing::rigged_model();
    const auto add = [&](const char* name, float end) {
        Channel swell = model.clips[1].channels.front();
        swell.times_s = {0, end / 2, end};
        swell.values = {0, 1, 0};
        model.clips.push_back({name, {swell}, 0, double{end}});
    };
    add("often", 0x1p-6f);
    add("blink", 1e-12f);
    testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
    for (const Playing& often : {Playing{.clip = "often", .speed = 384},
                                 Playing{.clip = "blink", .speed = 1e-9, .offset = 1e6}}) {
        const AnimatedExport made = exported(playing(round(), often));
        EXPECT_THAT(of(made, 5).front().unproven, HasSubstr("its clip")) << often.clip;
        EXPECT_THAT(not_certified(made.certificate), ::testing::Not(IsEmpty()));
    }
}

TEST_F(FilmClaims, OfAThingThatJumpsSaySo)
{
    const Document document = travelling(laid(), {.speed = 6, .ends = Ends::loop});
    const AnimatedExport made = exported(document);
    EXPECT_THAT(of(made, 5).front().unproven, HasSubstr("jumps"));
    EXPECT_GE(of(made, 5).front().moments, 4); // as all that is compared at moments alone
}

} // namespace
} // namespace trivar
