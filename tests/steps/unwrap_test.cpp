// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/paste.h"
#include "core/commands/tiles/tiles.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/unwrap/unwrap.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::new_evaluator;
using ::testing::ThrowsMessage;

Ref<EvaluatedObject> unwrap_result(const Document& document, Id id = 1)
{
    return new_evaluator()(document, 1).objects.at(id);
}

Document a_ball()
{
    return after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 32, .rings = 16}});
}

TEST(UnwrappedObjects, HaveOtherUvsAndTheSameSurface)
{
    const Ref<EvaluatedObject> before = unwrap_result(a_ball()),
                               now = unwrap_result(after(a_ball(), Unwrap{{1}, {}}));
    ASSERT_TRUE(now->unwrapped);
    EXPECT_GT(now->unwrapped->charts, 2u);
    EXPECT_EQ(now->unwrapped->left_out, 0u);
    const Mesh &a = *before->parts.at(0).rest, &b = *now->parts.at(0).rest;
    ASSERT_EQ(a.corners.size(), b.corners.size());
    bool same = true;
    for (std::size_t c = 0; c < a.corners.size(); ++c) {
        ASSERT_EQ(a.positions[a.corners[c]], b.positions[b.corners[c]]);
        same &= a.uvs[0][a.corners[c]] == b.uvs[0][b.corners[c]];
    }
    EXPECT_FALSE(same);
    EXPECT_TRUE(now->notices.empty());
}

TEST(UnwrappedObjects, GetTheirOwnUvsBack)
{
    const Document document = after(a_ball(), Unwrap{{1}, {}});
    EXPECT_NE(digest(document), digest(a_ball()));
    EXPECT_EQ(digest(after(document, ClearUnwrap{{1}})), digest(a_ball()));
    EXPECT_FALSE(unwrap_result(after(document, ClearUnwrap{{1}}))->unwrapped);
}

TEST(UnwrappedObjects, AreCopiedAsTheyAre)
{
    const Document document =
        after(a_ball(), Unwrap{{1}, {.method = UnwrapMethod::rigid, .spread_deg = 45}});
    const Document both = after(document, copied(document, {1}, "/nowhere"));
    EXPECT_EQ(both.objects.at(2)->unwrapping, document.objects.at(1)->unwrapping);
}

TEST(UnwrappedObjects, AreSimplifiedFirst)
{
    Document document = after(a_ball(), Unwrap{{1}, {}});
    document = after(document, Simplify{{1}, {.keep = 0.25}});
    const Ref<EvaluatedObject> now = unwrap_result(document);
    EXPECT_EQ(triangles(*now->parts.at(0).rest).size(), now->triangles);
    EXPECT_TRUE(now->unwrapped);
}

TEST(UnwrappedObjects, HaveASurfaceOfTheirOwn)
{
    EXPECT_THAT(
        [&] {
            after(after(a_ball(), Group{{1}}), Unwrap{{2}, {}});
        },
        ThrowsMessage<Rejected>(HasSubstr("unwrap the objects in it")));
    EXPECT_THAT(
        [&] {
            after(a_ball(), Unwrap{{1}, {.spread_deg = 0}});
        },
        ThrowsMessage<Rejected>(HasSubstr("spread_deg")));
}

// A plane of 2 by 1 whose texture coordinates are its own square, and a tile.
Document a_table(const TileCover& cover)
{
    Document document = after(Document{}, AddPlane{.shape = {{2, 1}, {4, 4}}, .transform = {}});
    document = after(document, AddPlane{.shape = {{1, 1}, {1, 1}}, .transform = {}});
    return after(document, CoverWithTiles{2, 1, cover});
}

std::size_t tiles_in(const EvaluatedObject& layer)
{
    return layer.parts.empty() ? 0 : layer.parts.at(0).tiles->tiles->size();
}

TEST(TilesByTexture, LieOneOnEachCell)
{
    for (const int n : {1, 3, 10}) {
        const Ref<EvaluatedObject> layer = unwrap_result(
            a_table({.pattern = TilePattern::texture, .columns = 2 * n, .rows = n}), 2);
        EXPECT_EQ(tiles_in(*layer), static_cast<std::size_t>(2 * n * n));
        EXPECT_TRUE(layer->notices.empty());
    }
}

TEST(TilesByTexture, HaveTheSizeOfTheirCell)
{
    const Ref<EvaluatedObject> layer =
        unwrap_result(a_table({.pattern = TilePattern::texture, .columns = 10, .rows = 5}), 2);
    const Box box = *layer->bounds;
    EXPECT_NEAR(box.size().x, 2, 1e-5);
    EXPECT_NEAR(box.size().y, 1, 1e-5);
}

TEST(TilesByTexture, AreTheSameWhereThePaintedSurfaceMoves)
{
    Document document = a_table({.pattern = TilePattern::texture, .columns = 6, .rows = 3});
    document = after(document, SetTransform{{1}, {Transform{.translation = {0, 0, 5}}}});
    const Ref<EvaluatedObject> layer = unwrap_result(document, 2);
    EXPECT_EQ(tiles_in(*layer), 18u);
    EXPECT_NEAR(layer->bounds->lo.z, 5, 1e-5);
}

TEST(TilesByTexture, CoverWhatIsUnwrapped)
{
    Document document = after(a_ball(), AddPlane{.shape = {{1, 1}, {1, 1}}, .transform = {}});
    document = after(document, Unwrap{{1}, {}});
    document =
        after(document,
              CoverWithTiles{2, 1, {.pattern = TilePattern::texture, .columns = 30, .rows = 30}});
    const Ref<EvaluatedObject> base = unwrap_result(document, 1),
                               layer = unwrap_result(document, 2);
    const double cells = 900 * base->unwrapped->filled;
    EXPECT_LT(static_cast<double>(tiles_in(*layer)), 1.05 * cells);
    EXPECT_GT(static_cast<double>(tiles_in(*layer)), 0.85 * cells);
}

TEST(TilesByTexture, LieOnCagesAndOnLimitSurfacesOnceTheseAreUnwrapped)
{
    for (const int levels : {0, 2}) {
        ImportModel import;
        import.file.path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/cages/torus.obj";
        import.file.subdivisions = levels;
        Document document = after(Document{}, import);
        document = after(document, AddPlane{.shape = {{1, 1}, {1, 1}}, .transform = {}});
        document = after(
            document,
            CoverWithTiles{2, 1, {.pattern = TilePattern::texture, .columns = 40, .rows = 40}});
        const Ref<EvaluatedObject> without = unwrap_result(document, 2);
        EXPECT_EQ(tiles_in(*without), 0u);
        EXPECT_THAT(without->notices, ::testing::Contains(HasSubstr("unwrap it first")));
        document = after(document, Unwrap{{1}, {}});
        EXPECT_GT(tiles_in(*unwrap_result(document, 2)), 400u) << levels;
    }
}

} // namespace
} // namespace trivar
