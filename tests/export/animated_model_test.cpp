// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/certificate/film_check.h"
#include "core/export/animated_files.h"
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

class AnimatedExports : public testing::ExportedScenes {};

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

TEST_F(AnimatedExports, WithoutAToleranceAreWithinAMillimetreOrWhatTheirMotionAllows)
{
    for (const double speed : {1.5, 60.0}) {
        const Document document =
            travelling(laid(), {.speed = speed, .ends = Ends::back_and_forth});
        const AnimatedExport made = exported(document, 0);
        EXPECT_EQ(made.certificate.tolerance > default_tolerance, speed > 50) << speed;
        EXPECT_GE(made.certificate.tolerance, default_tolerance);
        EXPECT_LE(made.certificate.bound, made.certificate.tolerance);
        // Whoever verifies it writes it again with the tolerance that it tells.
        EXPECT_EQ(write_glb(exported(document, made.certificate.tolerance).model),
                  write_glb(made.model));
    }
}

TEST_F(AnimatedExports, TellTheirProgressOnce)
{
    const Document document =
        travelling(laid(), {.speed = 20, .ends = Ends::back_and_forth, .ease_in = 0.1});
    std::vector<double> told;
    animated_export({document, {1, 7}, 0, "a.trivar"}, assets_,
                    [&](double done, std::string_view) { told.push_back(done); });
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_LE(told.back(), 1);
    EXPECT_GT(told.size(), 10u);
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
        EXPECT_THAT(why.what(), HasSubstr("finer than the precision of the coordinates"));
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
    EXPECT_EQ(shown.interpolation, Channel::Interpolation::step);
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
    EXPECT_THROW(exported(laid(), -1), Rejected);
    EXPECT_THROW(exported(laid(), NAN), Rejected);
    EXPECT_THROW(frame_range("0:3", laid().time), Rejected);
    EXPECT_THROW(frame_range("3:2", laid().time), Rejected);
    EXPECT_THROW(frame_range("a", laid().time), Rejected);
    EXPECT_EQ(frame_range("", laid().time), (FrameRange{1, 7}));
    EXPECT_EQ(frame_range("3", laid().time), (FrameRange{3, 3}));
}

} // namespace
} // namespace trivar
