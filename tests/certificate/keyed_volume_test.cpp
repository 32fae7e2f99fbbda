// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/film_check.h"
#include "core/certificate/keyed_volume.h"
#include "core/commands/objects/shape.h"
#include "tests/export/scenes.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;

class KeyedVolumes : public testing::ExportedScenes {
protected:
    // The bar on the table, with control points of its volume's roof that are moved by keys.
    Document lifted(const std::string& axis, std::vector<Key> keys, bool guard = true) const
    {
        const MovePoints move{5, {.points = {{14, 4, 3}, {15, 4, 3}, {16, 4, 3}}, .guard = guard}};
        return keyed(after(laid(), move), 5, "shaping.0.shift.by." + axis, std::move(keys));
    }
    // Returns the claim for the bar, which holds at twenty times the frame rate.
    FilmCertificate::PartClaim claimed(const Document& document, double tolerance = 2e-3) const
    {
        const AnimatedExport made = exported(document, tolerance);
        const std::vector<FilmSample> found = sampled_film(made, document, assets_, 20);
        for (std::size_t p = 0; p < found.size(); ++p)
            if (const auto& claim = made.certificate.parts[p]; claim.object == 5) {
                EXPECT_LE(found[p].furthest, claim.bound) << "at frame " << found[p].at_frame;
                return claim;
            }
        return {};
    }
};

TEST_F(KeyedVolumes, AreProvenWhileControlPointsAreMoved)
{
    for (const bool guard : {true, false})
        for (const Tween tween : {Tween::linear, Tween::cubic}) {
            const auto claim =
                claimed(lifted("z",
                               {{.frame = 1, .value = 0, .tween = tween},
                                {.frame = guard ? 3 : 3.3, .value = 0.05, .tween = tween},
                                {.frame = 7, .value = -0.02, .tween = tween}},
                               guard));
            EXPECT_THAT(claim.unproven, IsEmpty());
            EXPECT_LE(claim.bound, 2e-3);
            EXPECT_GT(claim.motion, 0);
        }
}

TEST_F(KeyedVolumes, AreProvenWhileASkinBendsInThem)
{
    const Document document =
        playing(lifted("y", {{.frame = 1, .value = 0}, {.frame = 7, .value = 0.01}}),
                {.clip = "bend", .repeat = Repeat::back_and_forth});
    const auto claim = claimed(document, 2e-2);
    EXPECT_THAT(claim.unproven, IsEmpty());
    EXPECT_GT(claim.motion, 0);
}

TEST_F(KeyedVolumes, AreNotProvenWhereTheGuardActsOrTheyTravel)
{
    const std::vector<Key> far{{.frame = 1, .value = 0}, {.frame = 7, .value = -1}};
    EXPECT_THAT(claimed(lifted("z", far)).unproven, HasSubstr("not bounded"));
    const Document document =
        travelling(lifted("z", {{.frame = 1, .value = 0}, {.frame = 7, .value = 0.05}}),
                   {.speed = 0.2, .ends = Ends::stay});
    EXPECT_THAT(claimed(document).unproven, HasSubstr("shaping.0.shift.by.z has keys"));
}

TEST(OffChord, IsNoLessThanWhatIsSampled)
{
    const std::vector<Key> keys{{.frame = 1, .value = 0},
                                {.frame = 2, .value = 3, .tween = Tween::linear},
                                {.frame = 3.5, .value = -1, .after = {1.4, 0}},
                                {.frame = 5, .value = 2, .tween = Tween::step},
                                {.frame = 6, .value = 0.5}};
    for (const Repeat repeat : {Repeat::once, Repeat::loop, Repeat::back_and_forth}) {
        const Track track{"a", keys, repeat};
        for (double from = 0; from < 20; from += 0.37)
            for (const double way : {0.05, 0.4, 1.0, 7.0}) {
                const double v0 = value_at(track, from), v1 = value_at(track, from + way);
                double sampled = 0;
                for (int i = 0; i <= 500; ++i)
                    sampled = std::max(sampled, std::abs(value_at(track, from + way * i / 500) -
                                                         std::lerp(v0, v1, i / 500.0)));
                const double bound = off_chord(track, from, from + way, -10, 10);
                EXPECT_LE(sampled, bound + 1e-9) << from << " " << way;
                EXPECT_LE(bound, 8) << from << " " << way;
            }
        EXPECT_TRUE(std::isinf(off_chord(track, 1, 6, -0.5, 10)));
    }
    const Track tiny{"a", {{.frame = 1}, {.frame = 1 + 1e-14, .value = 1}}, Repeat::loop};
    EXPECT_TRUE(std::isinf(off_chord(tiny, 1e4, 1e4, -10, 10)));
    const Track smooth{"a", {{.frame = 0, .value = 0}, {.frame = 8, .value = 1}}};
    EXPECT_LE(off_chord(smooth, 1, 1.5, -10, 10), 4.5e-3); // 1/8 of the second derivative, 6 / 64
}

} // namespace
} // namespace trivar
