// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/export/animated_files.h"
#include "core/export/film_check.h"
#include "core/files/formats.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "tests/export/scenes.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;
using Claim = FilmCertificate::PartClaim;

class AnimatedExports : public testing::ExportedScenes {
protected:
    // What is proven keeps to its own bound at ten times the frame rate, all else to the tolerance.
    void expect_holds(const Document& document, const AnimatedExport& made,
                      int per_frame = 10) const
    {
        const std::vector<FilmSample> found = sampled_film(made, document, assets_, per_frame);
        for (std::size_t p = 0; p < found.size(); ++p) {
            const Claim& claim = made.certificate.parts[p];
            EXPECT_GT(found[p].samples, 0u);
            constexpr double rounding = 1e-6; // of single precision
            EXPECT_LE(found[p].furthest,
                      is_proven(claim) ? claim.bound + rounding : made.certificate.tolerance)
                << claim.name << " " << claim.way << " at frame " << found[p].at_frame << " "
                << claim.unproven;
        }
    }
    static std::vector<Claim> of(const AnimatedExport& made, Id object)
    {
        std::vector<Claim> out;
        for (const Claim& claim : made.certificate.parts)
            if (claim.object == object) out.push_back(claim);
        return out;
    }
};

TEST_F(AnimatedExports, KeepToTheirCertificateAtTenTimesTheFrameRateHoweverThingsTravel)
{
    for (const Ends ends : {Ends::stay, Ends::hide, Ends::back_and_forth}) {
        const Document document = travelling(
            laid(),
            {.speed = 1.5, .ends = ends, .ease_in = 0.1, .ease_out = 0.15, .start_frame = 2});
        const AnimatedExport made = exported(document);
        EXPECT_LE(made.certificate.bound, 2e-3);
        EXPECT_EQ(of(made, 5).front().way, "targets");
        expect_holds(document, made);
    }
}

TEST_F(AnimatedExports, AreProvenRoundABandThatTwistsWithTwoFollowing)
{
    const Document document = travelling(round(), {.speed = 2, .ends = Ends::loop, .followers = 2});
    const AnimatedExport made = exported(document);
    ASSERT_EQ(of(made, 5).size(), 3u);
    EXPECT_THAT(not_certified(made.certificate), IsEmpty());
    EXPECT_LE(made.certificate.bound, 2e-3);
    expect_holds(document, made);
}

TEST_F(AnimatedExports, AreProvenOnAStrokeThatIsProlongedAtBothEnds)
{
    for (const double speed : {1.5, -1.5})
        for (const double start : {0.0, 0.3}) {
            Document document = laid();
            PlacementParameters p = object(document, 5).placement->parameters;
            p.start = start;
            document = travelling(after(document, EditPlacement{5, p, {}, {}}),
                                  {.speed = speed, .ends = Ends::run_on, .followers = 1});
            const AnimatedExport made = exported(document);
            EXPECT_THAT(not_certified(made.certificate), IsEmpty()) << speed << " " << start;
            expect_holds(document, made, 20);
        }
}

TEST_F(AnimatedExports, AreProvenWhereARingBeginsAgain)
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

TEST_F(AnimatedExports, AreProvenWhileASkinBendsInAVolumeAndTravels)
{
    const Document document = playing(travelling(round(), {.speed = 0.4, .ends = Ends::loop}),
                                      {.clip = "bend", .repeat = Repeat::back_and_forth});
    const AnimatedExport made = exported(document, 2e-2);
    EXPECT_EQ(of(made, 5).front().way, "targets");
    EXPECT_THAT(of(made, 5).front().unproven, IsEmpty());
    EXPECT_GT(of(made, 5).front().between, 0);
    expect_holds(document, made);
}

TEST_F(AnimatedExports, AreProvenWhileASkinBendsByACubic)
{
    Model model = testing::rigged_model();
    Channel& turn = model.clips[0].channels.front();
    const std::vector<float> from(turn.values.begin(), turn.values.begin() + 4),
        to(turn.values.begin() + 4, turn.values.end());
    const std::vector<float> slope_from{0, 0, 1.5f, 0}, slope_to{0.1f, 0, -0.4f, 0.3f};
    turn.between = Channel::Between::cubic;
    turn.values.clear();
    for (const auto& part : {slope_from, from, slope_from, slope_to, to, slope_to})
        turn.values.insert(turn.values.end(), part.begin(), part.end());
    testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
    const Document document = playing(travelling(round(), {.speed = 0.4, .ends = Ends::loop}),
                                      {.clip = "bend", .repeat = Repeat::back_and_forth});
    const AnimatedExport made = exported(document, 2e-2);
    EXPECT_THAT(of(made, 5).front().unproven, IsEmpty());
    EXPECT_GT(of(made, 5).front().between, 0);
    expect_holds(document, made);
}

TEST_F(AnimatedExports, AreProvenBeyondTheEndOfAClipThatIsPlayedOnce)
{
    for (const bool steps : {false, true}) {
        Model model = testing::rigged_model();
        if (steps) { // stands at its last key as it does nowhere before
            Channel& turn = model.clips[0].channels.front();
            turn.between = Channel::Between::step;
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
        EXPECT_LT(of(held, 5).front().between, 2e-3); // by travel alone
        expect_holds(late, held);
    }
}

TEST_F(AnimatedExports, AreProvenWhileMorphTargetsSwellInAVolume)
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
            EXPECT_GT(of(made, 5).front().between, 0) << clip;
            EXPECT_LE(made.certificate.bound, 2e-2) << clip;
            expect_holds(document, made);
        }
}

TEST_F(AnimatedExports, SayWhatIsNotProven)
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

TEST_F(AnimatedExports, SayThatNothingIsKnownOfAClipThatGoesRoundVeryOften)
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

TEST_F(AnimatedExports, OfAThingThatJumpsSaySo)
{
    const Document document = travelling(laid(), {.speed = 6, .ends = Ends::loop});
    const AnimatedExport made = exported(document);
    EXPECT_THAT(of(made, 5).front().unproven, HasSubstr("jumps"));
    EXPECT_GE(of(made, 5).front().moments, 4); // as all that is compared at moments alone
}

TEST_F(AnimatedExports, GiveARigidObjectKeysOfItsNodeAndNoTargets)
{
    const Document document = keyed(still_, 2, "transform.rotation_deg.z",
                                    {{.frame = 1, .value = 0}, {.frame = 7, .value = 170}});
    const AnimatedExport made = exported(document);
    const Claim claim = of(made, 2).front();
    EXPECT_EQ(claim.way, "node");
    EXPECT_EQ(claim.triangles, claim.triangles_before);
    const Node& node = made.model.nodes[static_cast<std::size_t>(claim.node)];
    EXPECT_THAT(made.model.meshes[static_cast<std::size_t>(node.mesh)]->morph_targets, IsEmpty());
    ASSERT_EQ(made.model.clips.size(), 1u);
    expect_holds(document, made);
}

TEST_F(AnimatedExports, KeepTheSkinOfWhatLiesInNoVolume)
{
    for (const char* clip : {"bend", "swell"}) {
        const Document document = playing(still_, {.clip = clip});
        const AnimatedExport made = exported(document);
        EXPECT_EQ(of(made, 5).front().way, "skin") << clip;
        EXPECT_EQ(made.model.skins.size(), 1u);
        const Mesh& mesh = *made.model.meshes.back();
        EXPECT_EQ(mesh.morph_targets.size(), clip == std::string("swell") ? 1u : 0u);
        EXPECT_FALSE(mesh.influences.empty());
        expect_holds(document, made);
    }
}

TEST_F(AnimatedExports, ClaimOfNodesAndSkinsWhatSinglePrecisionMakesOfThem)
{
    const Document document = playing(still_, {.clip = "bend"});
    const double bound = of(exported(document), 5).front().bound;
    EXPECT_GT(bound, 0);
    EXPECT_LT(bound, 1e-5);
    try {
        exported(document, 1e-12);
        FAIL() << "was exported";
    } catch (const Rejected& why) {
        EXPECT_THAT(why.what(), HasSubstr("finer than single precision tells places apart"));
    }
}

TEST_F(AnimatedExports, LeaveOutWhatDoesNotMove)
{
    Model model = testing::rigged_model();
    Mesh mesh = *model.meshes.front();
    mesh.morph_targets.front().normals.clear();
    std::vector<glm::vec3>& differences = mesh.morph_targets.front().positions;
    differences.assign(mesh.vertex_count(), glm::vec3(0));
    differences.at(3) = {1, 2, 3};
    model.meshes.front() = make_ref(mesh);
    EXPECT_THAT(write_glb(model), HasSubstr("\"sparse\":{\"count\":1,"));
    write_model(model, folder_.file("a.glb"));
    const Model read = read_model(folder_.file("a.glb"));
    EXPECT_EQ(read.meshes.front()->morph_targets.front().positions, differences);
    EXPECT_EQ(read.meshes.front()->influences.size(), mesh.influences.size());
    ASSERT_EQ(read.clips.size(), model.clips.size());
    EXPECT_EQ(read.clips.front().channels.front().values,
              model.clips.front().channels.front().values);
}

TEST_F(AnimatedExports, GiveWhatRestsNoKeys)
{
    const AnimatedExport made = exported(laid());
    EXPECT_THAT(made.model.clips, IsEmpty());
    for (const Claim& claim : made.certificate.parts) {
        EXPECT_EQ(claim.way, "still") << claim.name;
        EXPECT_TRUE(is_proven(claim)) << claim.name;
    }
    for (const std::string& line : summary(made.certificate))
        EXPECT_THAT(line, ::testing::Not(::testing::EndsWith("frame"))) << "it is proven";
    for (const Ref<Mesh>& mesh : made.model.meshes) EXPECT_THAT(mesh->morph_targets, IsEmpty());
    expect_holds(laid(), made);
}

TEST_F(AnimatedExports, ProveNothingOfWhatRestsAtTheMomentsOnly)
{
    const Document document =
        keyed(still_, 2, "transform.translation.x",
              {{.frame = 2, .value = 0}, {.frame = 2.1, .value = 1}, {.frame = 2.2, .value = 0}});
    const Claim claim = of(exported(document), 2).front();
    EXPECT_EQ(claim.way, "node");
    EXPECT_FALSE(is_proven(claim));
    EXPECT_EQ(when_claimed(false, 1), " at every frame");
}

TEST_F(AnimatedExports, ShrinkWhatIsNotShownToAPoint)
{
    const Document document = keyed(still_, 2, "hidden",
                                    {{.frame = 1, .value = 0, .tween = Tween::step},
                                     {.frame = 4, .value = 1, .tween = Tween::step}});
    const AnimatedExport made = exported(document);
    ASSERT_EQ(made.model.clips.size(), 1u);
    const Channel& shown = made.model.clips.front().channels.front();
    EXPECT_EQ(shown.of, Channel::Of::scale);
    EXPECT_EQ(shown.between, Channel::Between::step);
    EXPECT_THAT(value_at(shown, 2.9 / 12), ::testing::Each(1.0));
    EXPECT_THAT(value_at(shown, 3.1 / 12), ::testing::Each(0.0));
}

TEST_F(AnimatedExports, HaveTheSameBitsForAnyNumberOfThreads)
{
    const Document document = travelling(round(), {.speed = 1, .ends = Ends::loop});
    const std::string many = write_glb(exported(document).model);
    const ThreadLimit one(1);
    EXPECT_EQ(write_glb(exported(document).model), many);
}

TEST_F(AnimatedExports, NeedFewerKeysWhereMoreIsAllowed)
{
    const Document document = travelling(round(), {.speed = 1, .ends = Ends::loop});
    const int fine = of(exported(document, 5e-4), 5).front().keys,
              coarse = of(exported(document, 1e-2), 5).front().keys;
    EXPECT_GT(fine, coarse);
    EXPECT_GE(coarse, 2);
}

TEST_F(AnimatedExports, KeepTheirCertificateThroughItsText)
{
    const FilmCertificate given = exported(laid()).certificate;
    const FilmCertificate read = film_certificate_from_json(to_json(given));
    EXPECT_EQ(to_json(read), to_json(given));
    EXPECT_THROW(film_certificate_from_json("{}"), Rejected);
    EXPECT_THROW(film_certificate_from_json("[1"), Rejected);
}

TEST_F(AnimatedExports, MayBeCopied)
{
    const Document document = travelling(laid(), {.speed = 1.5});
    AnimatedExport copy;
    {
        AnimatedExport made = exported(document);
        copy = made;
        made.film.strips.clear();
    }
    expect_holds(document, copy);
}

TEST_F(AnimatedExports, OfMoreThanMemoryHoldsAreRefusedAtOnce)
{
    EXPECT_THROW(film_of(laid(), assets_, std::vector<double>(most_kept + 1, 1)), Rejected);
    EXPECT_EQ(film_of(laid(), assets_, moments_of({1, 3}, 1)).kept, 3u + 4u); // nothing moves
}

TEST_F(AnimatedExports, HaveWholeNumbersInTheirCertificate)
{
    const std::string text = to_json(exported(laid()).certificate);
    for (const char* name : {"object", "part", "node", "keys", "moments_per_frame", "triangles"}) {
        const std::string key = "\"" + std::string(name) + "\":";
        const std::size_t at = text.find(key) + key.size();
        for (const char* other : {"1e300", "-1e19", "1.5", "true", "99999999999999999999"}) {
            std::string changed = text;
            changed.replace(at, changed.find_first_of(",}", at) - at, other);
            EXPECT_THROW(film_certificate_from_json(changed), Rejected) << name << " " << other;
        }
    }
}

TEST_F(AnimatedExports, OfNothingAreRefused)
{
    Document empty;
    EXPECT_THROW(animated_export({empty, {1, 2}, 1e-3, ""}, assets_), Rejected);
    EXPECT_THROW(exported(laid(), 0), Rejected);
    EXPECT_THROW(exported(laid(), NAN), Rejected);
    EXPECT_THROW(frame_range("0:3", laid().time), Rejected);
    EXPECT_THROW(frame_range("3:2", laid().time), Rejected);
    EXPECT_THROW(frame_range("a", laid().time), Rejected);
    EXPECT_EQ(frame_range("", laid().time), (FrameRange{1, 7}));
    EXPECT_EQ(frame_range("3", laid().time), (FrameRange{3, 3}));
}

} // namespace
} // namespace trivar
