// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/certificate/film_check.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/objects/text.h"
#include "core/export/animated_files.h"
#include "core/mesh/closed_body.h"
#include "tests/export/scenes.h"
#include "tests/support/scenes/incised_ball.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

class ChangingTriangles : public testing::ExportedScenes {
protected:
    // A word 6 that becomes thicker, and gets more rows of triangles for that.
    Document growing() const
    {
        AddText add;
        add.shape = {.text = "illi", .size = 0.5, .depth = 0.06, .max_edge = 0.15};
        Document document = after(still_, add);
        return keyed(document, 6, "shape.depth",
                     {{.frame = 1, .value = 0.06}, {.frame = 7, .value = 0.1}});
    }
    void expect_holds(const Document& document, const AnimatedExport& made, Id id) const
    {
        const std::vector<FilmSample> found = sampled_film(made, document, assets_, 10);
        std::size_t samples = 0;
        for (std::size_t p = 0; p < found.size(); ++p) {
            if (made.certificate.parts[p].object != id) continue;
            EXPECT_LE(found[p].furthest, made.certificate.tolerance)
                << made.certificate.parts[p].name << " at frame " << found[p].at_frame;
            samples += found[p].samples;
        }
        EXPECT_GT(samples, 1000u);
    }
};

TEST_F(ChangingTriangles, AreMeshesShownOneAfterTheOther)
{
    const Document document = growing();
    const AnimatedExport made = exported(document, 5e-3);
    std::vector<const FilmStrip*> pieces;
    for (std::size_t p = 0; p < made.film.strips.size(); ++p)
        if (made.certificate.parts[p].object == 6) {
            pieces.push_back(&made.film.strips[p]);
            EXPECT_EQ(made.certificate.parts[p].way, "targets");
            EXPECT_THAT(made.certificate.parts[p].unproven, HasSubstr("keys change its shape"));
        }
    ASSERT_GT(pieces.size(), 1u);
    for (std::size_t i = 0; i < made.film.moments.size(); ++i)
        EXPECT_EQ(std::ranges::count_if(pieces,
                                        [&](const FilmStrip* p) { return p->shown[i] != nullptr; }),
                  1)
            << "at frame " << made.film.moments[i];
    EXPECT_THAT(pieces[1]->name, HasSubstr(" from frame "));
    expect_holds(document, made, 6);
}

TEST_F(ChangingTriangles, OfAVolumesObjectDoSoToo)
{
    Document document = growing();
    PlacementParameters p;
    p.fill = 0.4;
    document = after(document, Place{6, testing::small_sketch(), p, {1}});
    const AnimatedExport made = exported(document, 5e-3);
    EXPECT_GT(std::ranges::count(made.certificate.parts, 6, &FilmCertificate::PartClaim::object),
              1);
    expect_holds(document, made, 6);
}

TEST_F(ChangingTriangles, OfATextAreInvisiblePrimsInAnUsdFileAndNoPointCache)
{
    const AnimatedScene scene{growing(), {1, 7}, 1e-3, ""};
    write_animated(scene, assets_, folder_.file("a.usda"));
    EXPECT_THAT(read_text_file(folder_.file("a.usda")), HasSubstr("_from_frame_"));
    try {
        write_animated(scene, assets_, folder_.file("a.pc2"));
        FAIL();
    } catch (const Rejected& error) {
        EXPECT_THAT(error.what(), HasSubstr("a point cache holds one mesh"));
    }
}

TEST_F(ChangingTriangles, StayWhereOnlyTheirVerticesMove)
{
    const Document document =
        keyed(still_, 2, "shape.radius", {{.frame = 1, .value = 0.5}, {.frame = 7, .value = 0.7}});
    const AnimatedExport made = exported(document, 2e-2);
    EXPECT_EQ(std::ranges::count(made.certificate.parts, 2, &FilmCertificate::PartClaim::object),
              1);
    expect_holds(document, made, 2);
    write_animated({document, {1, 7}, 1e-3, ""}, assets_, folder_.file("a.usda"));
    const std::string text = read_text_file(folder_.file("a.usda"));
    const std::size_t at = text.find("def Mesh \"" + object(document, 2).name);
    ASSERT_NE(at, text.npos);
    EXPECT_THAT(text.substr(at, text.find("def Mesh", at + 1) - at),
                HasSubstr("points.timeSamples"));
}

// Pieces of a model that has nodes of its own do not ride on these: a gap moves them apart.
TEST_F(ChangingTriangles, OfAModelThatIsCutMoveByThemselves)
{
    const Document cut =
        after(still_, CutThrough{.objects = {5}, .cutting = {.cuts = {{.gap = 0.3}}}});
    for (const Document& document : {cut, playing(cut, {.clip = "bend"})}) {
        const AnimatedExport made = exported(document, 5e-3);
        EXPECT_GE(
            std::ranges::count(made.certificate.parts, 5, &FilmCertificate::PartClaim::object), 2);
        expect_holds(document, made, 5);
    }
}

// A ball 1 with an incision at some opening, in the time of the other scenes.
Document incised_scene(double opening)
{
    Document document = testing::incised_ball(opening);
    document.time = {.first_frame = 1, .last_frame = 7, .frames_per_second = 12};
    return document;
}

TEST_F(ChangingTriangles, AreNoneWhereAnIncisionOpensInTime)
{
    const Document opens = keyed(incised_scene(0), 1, "incising.cuts.0.opening",
                                 {{.frame = 1}, {.frame = 3}, {.frame = 7, .value = 1}});
    const AnimatedExport made = exported(opens, 5e-3);
    ASSERT_EQ(made.film.strips.size(), 1u);
    EXPECT_EQ(made.certificate.parts.at(0).way, "targets");
    const Ref<Mesh> shut = made.film.strips[0].shown.front()->mesh();
    EXPECT_TRUE(is_closed_body(*shut));
    EXPECT_GT(shut->face_count(), testing::ball_in(opens, 1)->parts.at(0).mesh()->face_count());
    expect_holds(opens, made, 1);
}

TEST_F(ChangingTriangles, AreNoneWhereAnIncisionStaysShut)
{
    const Document shut = incised_scene(0);
    const AnimatedExport made = exported(shut);
    ASSERT_EQ(made.film.strips.size(), 1u);
    EXPECT_EQ(made.film.strips[0].shown.front()->mesh()->corners,
              testing::ball_in(shut, 1)->parts.at(0).mesh()->corners);
}

} // namespace
} // namespace trivar
