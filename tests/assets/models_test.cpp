// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/check.h"
#include "assets/make/models/cages.h"
#include "assets/make/models/models.h"
#include "assets/make/texture.h"
#include "assets/make/volumes/volumes.h"
#include "assets/make/write_model.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>

namespace {

using glm::vec3;

// A Row of the table of docs/assets.md; sizes to a hundredth.
struct Row {
    std::string name;
    vec3 size;
    int pieces;
    int open_edges = 0;
};

std::vector<Row> table()
{
    return {{"snake", {1.04f, .06f, .07f}, 7},
            {"crocodile", {1.00f, .11f, .46f}, 59},
            {"horse", {1.00f, 1.02f, .33f}, 9},
            {"camel", {.94f, .98f, .29f}, 9},
            {"whale", {1.05f, .26f, .53f}, 3},
            {"ant", {1.00f, .32f, .54f}, 30},
            {"reptile", {.99f, .08f, .43f}, 3},
            {"robot", {.43f, .98f, .52f}, 62},
            {"head", {.76f, 1.04f, .57f}, 7},
            {"forearm", {1.26f, .24f, .36f}, 1},
            {"mask", {.33f, .72f, .49f}, 1},
            {"car", {1.05f, .29f, .43f}, 81},
            {"car_blue", {1.05f, .29f, .43f}, 81},
            {"car_cream", {1.05f, .29f, .43f}, 81},
            {"bulldozer", {.96f, .64f, .58f}, 263},
            {"tree", {.95f, 1.24f, .80f}, 2},
            {"trunk", {.42f, 1.00f, .39f}, 1},
            {"terrain", {1.00f, .28f, 1.00f}, 1},
            {"jar", {.74f, 1.00f, .69f}, 3},
            {"pumpkin", {.98f, .89f, .99f}, 3},
            {"bottle", {.27f, 1.00f, .27f}, 3},
            {"wine_glass", {.26f, .66f, .26f}, 2},
            {"goblet", {.50f, 1.00f, .50f}, 19},
            {"dodecahedron", {1.00f, .86f, 1.05f}, 1},
            {"bars", {.69f, 1.00f, .09f}, 3},
            {"profile", {.61f, 1.00f, .80f}, 1},
            {"gear", {.99f, .20f, .99f}, 1},
            {"moebius", {.95f, .27f, 1.00f}, 1},
            {"moebius_lattice", {.96f, .29f, 1.02f}, 1},
            {"teapot", {1.61f, .79f, 1.00f}, 3, 160},
            {"book", {.74f, .18f, 1.00f}, 12},
            {"desk", {1.60f, .45f, 1.10f}, 8},
            {"mechanical", {1.00f, .41f, .64f}, 1},
            {"bones_hand", {.42f, .82f, .08f}, 1},
            {"bones_jaw", {.52f, .43f, .62f}, 4},
            {"crystal", {.98f, .98f, .98f}, 192},
            {"tile_thorn", {.98f, 1.00f, .98f}, 1},
            {"tile_flower", {.98f, .67f, .98f}, 1},
            {"tile_chain", {1.22f, .34f, .34f}, 2},
            {"tile_mail", {1.47f, .48f, 1.39f}, 2},
            {"tile_hair", {.78f, .94f, .69f}, 8},
            {"tile_hex", {1.23f, .26f, 1.14f}, 4},
            {"tile_brick_a", {.97f, .35f, .94f}, 1},
            {"tile_brick_b", {.96f, .37f, .94f}, 2},
            {"tile_brick_c", {.96f, .35f, .94f}, 1},
            {"tile_brick_hollow", {.96f, .35f, .94f}, 1},
            {"tile_scale", {1.00f, .36f, 1.23f}, 1},
            {"tile_statue", {.83f, .97f, .73f}, 1},
            {"tile_feather", {1.00f, .24f, .48f}, 10},
            {"tile_leaf", {1.00f, .39f, .68f}, 2},
            {"tile_grass", {.50f, .75f, .55f}, 11},
            {"tile_cobble", {.97f, .43f, .92f}, 1},
            {"tile_shingle", {.98f, .27f, 1.24f}, 1},
            {"tile_stud", {.98f, .37f, .98f}, 1},
            {"tile_rivet", {.98f, .35f, .98f}, 1},
            {"tile_rope", {1.00f, .43f, .42f}, 3},
            {"tile_braid", {1.00f, .38f, .66f}, 3},
            {"tile_lock", {1.00f, .26f, .51f}, 13},
            {"tile_knit", {1.00f, .44f, .98f}, 1},
            {"tile_robot", {.54f, 1.00f, .62f}, 28}};
}

make::Model made(const std::string& name)
{
    for (const make::Entry& entry : make::catalogue()) {
        if (entry.name == name) return make::build(entry);
    }
    ADD_FAILURE() << "no model is called " << name;
    return {};
}

std::string glb_bytes(const std::string& name, int threads)
{
    const trivar::ThreadLimit limit(threads);
    const trivar::testing::TemporaryFolder folder;
    make::write_glb(made(name), folder.file("model.glb"));
    std::ifstream file(folder.file("model.glb"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class EveryModel : public testing::TestWithParam<Row> {};

TEST_P(EveryModel, HasThePiecesAndTheSizeThatTheManualSays)
{
    const make::Report report = make::check(made(GetParam().name));
    EXPECT_EQ(report.pieces, GetParam().pieces);
    EXPECT_EQ(report.open, GetParam().open_edges);
    EXPECT_EQ(report.nonmanifold, 0);
    const vec3 size = report.hi - report.lo;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(size[axis], GetParam().size[axis], .011f);
}

INSTANTIATE_TEST_SUITE_P(Of, EveryModel, testing::ValuesIn(table()),
                         [](const auto& row) { return row.param.name; });

TEST(Catalogue, IsTheTableAndWhatTheBuildMakes)
{
    const std::vector<make::Entry> catalogue = make::catalogue();
    ASSERT_EQ(catalogue.size(), table().size());
    for (const make::Entry& entry : catalogue) {
        const std::string path = TRIVAR_BINARY_DIR "/assets/models/" + entry.name + ".glb";
        EXPECT_TRUE(std::filesystem::exists(path)) << path;
    }
}

TEST(Models, AreTheSameBitsWithOneThreadAndWithTwo)
{
    for (const char* name : {"snake", "ant", "tile_brick_a"}) {
        EXPECT_EQ(glb_bytes(name, 1), glb_bytes(name, 2)) << name;
    }
}

TEST(Models, HaveAMaterialForEveryPartAndColoursAndTextureCoordinatesForAllOfItOrNone)
{
    for (const char* name : {"snake", "jar", "terrain", "ant", "book", "teapot"}) {
        const make::Model model = made(name);
        for (const make::Node& node : model.nodes) {
            for (const make::Mesh& part : node.parts) {
                EXPECT_LT(part.material, int(model.materials.size()));
                EXPECT_TRUE(part.colors.empty() || part.colors.size() == part.points.size());
                EXPECT_TRUE(part.uvs.empty() || part.uvs.size() == part.faces.size());
            }
        }
    }
}

TEST(Mask, CoversTheUnitSquareOfTextureCoordinatesExactly)
{
    const make::Mesh mask = made("mask").nodes[0].parts[0];
    glm::vec2 lo(1e9f), hi(-1e9f);
    for (const auto& face : mask.uvs) {
        for (const glm::vec2& uv : face) {
            lo = glm::min(lo, uv);
            hi = glm::max(hi, uv);
        }
    }
    EXPECT_EQ(lo, glm::vec2(0));
    EXPECT_EQ(hi, glm::vec2(1));
}

TEST(Thorn, HasTheConnectivityOfTheFlowerSoThatTheyMorph)
{
    EXPECT_EQ(made("tile_thorn").nodes[0].parts[0].faces,
              made("tile_flower").nodes[0].parts[0].faces);
}

// In the planes x = 0 and x = 1 there are the same points, so that copies in a line continue.
TEST(WovenTiles, EndAsTheyBegin)
{
    for (const char* name : {"tile_rope", "tile_braid", "tile_lock", "tile_knit"}) {
        const make::Model model = made(name);
        for (const make::Mesh& part : model.nodes[0].parts) {
            std::vector<vec3> begin, end;
            for (const vec3& p : part.points) {
                if (std::abs(p.x) < 1e-5f) begin.push_back(p);
                if (std::abs(p.x - 1) < 1e-5f) end.push_back(p);
            }
            ASSERT_GT(begin.size(), 8u) << name;
            ASSERT_EQ(begin.size(), end.size()) << name;
            for (std::size_t i = 0; i < begin.size(); ++i)
                EXPECT_LT(glm::distance(begin[i] + vec3(1, 0, 0), end[i]), 1e-5f) << name;
        }
    }
}

TEST(Volumes, AreOfSizesThatTheManualSaysAndMadeByTheBuild)
{
    for (const make::NamedVolume& each : make::volumes()) {
        const std::string path = TRIVAR_BINARY_DIR "/assets/models/volumes/" + each.name + ".nrrd";
        ASSERT_TRUE(std::filesystem::exists(path)) << path;
        EXPECT_LT(std::filesystem::file_size(path), 4'000'000u) << path;
        const std::string head = trivar::read_text_file(path).substr(0, 8);
        EXPECT_EQ(head, "NRRD0004") << path;
    }
}

TEST(Volumes, AreTheSameBitsWithOneThreadAndWithTwo)
{
    const auto samples = [](int threads) {
        const trivar::ThreadLimit limit(threads);
        return make::rounded(make::foot()).samples;
    };
    EXPECT_EQ(samples(1), samples(2));
}

// A scanner's values: air, fat, muscle, bone; and tooth enamel is the hardest.
TEST(Volumes, HaveTheValuesOfTheirTissues)
{
    const auto share = [](const make::Volume& volume, int from, int to) {
        const auto count = std::ranges::count_if(
            volume.samples, [&](std::int16_t v) { return v >= from && v < to; });
        return double(count) / double(volume.samples.size());
    };
    const make::Volume foot = make::rounded(make::foot());
    EXPECT_GT(share(foot, -1001, -980), .5);
    EXPECT_GT(share(foot, -110, -70), .02);
    EXPECT_GT(share(foot, 30, 80), .05);
    EXPECT_GT(share(foot, 600, 1300), .05);
    const make::Volume jaw = make::rounded(make::jaw());
    EXPECT_GT(share(jaw, 1900, 2600), .0005);
    EXPECT_EQ(share(jaw, 2600, 4000), 0);
}

TEST(Cages, AreClosedQuadsWithTheirCreasesOnEdges)
{
    for (const make::Cage& cage : make::cages()) {
        make::Model model;
        model.root().parts.push_back(cage.mesh);
        const make::Report report = make::check(model);
        EXPECT_EQ(report.quads, report.faces) << cage.name;
        EXPECT_EQ(report.open + report.nonmanifold, 0) << cage.name;
        EXPECT_GT(report.volume, 0) << cage.name;
        std::set<std::pair<int, int>> edges;
        for (const make::Face& q : cage.mesh.faces) {
            for (std::size_t i = 0; i < 4; ++i) edges.insert(std::minmax(q[i], q[(i + 1) % 4]));
        }
        for (const make::Crease& c : cage.creases) {
            EXPECT_TRUE(edges.contains({c.a, c.b})) << cage.name;
        }
    }
}

TEST(Textures, HoldThePatternWhereTheSurfaceIs)
{
    // A unit quad whose colour is its position: texel (x, y) of 8 has the middle of its square.
    make::Mesh quad;
    quad.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.faces = {{0, 1, 2, 3}};
    quad.uvs = {{glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}};
    const make::Texture texture = make::bake(quad, {8, 8}, [](vec3 p) { return p; });
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const std::uint8_t* texel = &texture.rgb[std::size_t(3 * (y * 8 + x))];
            EXPECT_NEAR(texel[0], (float(x) + .5f) / 8 * 255, 1);
            EXPECT_NEAR(texel[1], (float(y) + .5f) / 8 * 255, 1);
        }
    }
}

TEST(Teapot, JoinsItsBottomToItsBody)
{
    // Newell's body, spout with handle, and lid each have free rims; a bottom that did not meet
    // the body would be a fourth piece with eighty more free edges.
    const make::Report report = make::check(made("teapot"));
    EXPECT_EQ(report.open, 160);
}

} // namespace
