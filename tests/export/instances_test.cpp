// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with tiles and copies, written as instances and read again.
#include "core/base/text.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/tiles/tiles.h"
#include "core/export/animated_files.h"
#include "core/export/still_export.h"
#include "core/export/usd_instances.h"
#include "core/files/formats.h"
#include "core/files/gltf/glb_content.h"
#include "core/files/read_model.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <set>
#include <sstream>

namespace trivar {
namespace {

using namespace testing;
using ::testing::AllOf, ::testing::HasSubstr;

constexpr Id ball = 2, stud = 5; // of studded()

// A layer of low studs of two sizes on the ball, and a teapot in a volume beside it.
Document studded()
{
    Document document =
        after(small_document(),
              AddCylinder{.name = "Stud",
                          .shape = {.radius = 0.1, .height = 0.05, .segments = 12, .stacks = 2}});
    for (const double size : {0.06, 0.12}) {
        TileStroke stroke = a_tile_stroke();
        stroke.radius = 0.2;
        stroke.size = size;
        if (size > 0.1) // on the other side
            for (TileSample& sample : stroke.samples) {
                sample.at.p *= -1.0;
                sample.at.normal *= -1.0;
            }
        document = after(document, PaintTiles{.object = stud, .base = ball, .stroke = stroke});
    }
    return document;
}

Evaluation shown(const Document& document, double frame = 1)
{
    return new_evaluator()(document, frame);
}

Export exported(const Document& document, std::optional<double> instances)
{
    return export_of(shown(document), {.document = document, .log = {}, .instances = instances});
}

// Whether a text, which may be long, has a part.
bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

// The corners of all faces of the nodes with a name, where these stand, Z up.
std::vector<glm::dvec3> corners_of(const Model& model, const std::string& name)
{
    std::vector<glm::dvec3> out;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0 || model.nodes[n].name != name) continue;
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)];
        for (const glm::uvec3& t : triangles(mesh))
            for (const std::uint32_t v : {t.x, t.y, t.z})
                out.emplace_back(node_to_model(model, static_cast<int>(n)) *
                                 glm::dvec4(glm::dvec3(mesh.positions[v]), 1));
    }
    return out;
}

Model through_glb(const Model& model, bool instances)
{
    return read_model_bytes(write_glb(model, {.instances = instances}), "a.glb", "");
}

TEST(Instances, ReadBackAreWhereTheBentTilesAreWithinTheTolerance)
{
    const Document document = studded();
    const Export plain = exported(document, {});
    const std::vector<glm::dvec3> bent = corners_of(through_glb(plain.model, false), "Stud");
    EXPECT_TRUE(plain.tiles.empty());
    for (const double tolerance : {0.01, 1e-3, 2e-4, 1e-9}) {
        const Export made = exported(document, tolerance);
        ASSERT_EQ(made.tiles.size(), 1u);
        const RigidCount& count = made.tiles.front();
        EXPECT_LE(count.off, tolerance);
        std::vector<glm::dvec3> back = corners_of(through_glb(made.model, true), "Stud");
        ASSERT_EQ(back.size(), bent.size()) << tolerance;
        double most = 0;
        for (std::size_t i = 0; i < back.size(); i += 7) {
            double nearest = 1e300;
            for (const glm::dvec3& p : bent) nearest = std::min(nearest, glm::distance(back[i], p));
            most = std::max(most, nearest);
        }
        EXPECT_LE(most, tolerance + 1e-6);
        if (tolerance == 0.01) { // all tiles, in their order
            EXPECT_EQ(count.sheared + count.bent, 0u);
            for (std::size_t i = 0; i < back.size(); ++i)
                EXPECT_LE(glm::distance(back[i], bent[i]), count.off + 1e-6);
        }
        if (tolerance == 1e-9) {
            EXPECT_EQ(count.instances + count.sheared, 0u);
            EXPECT_LT(count.off_bent, 0.01);
        }
    }
}

TEST(Instances, SayHowManyTilesThereAreAndHowFarTheyAreOff)
{
    const RigidCount all{.name = "Scales", .instances = 5, .off = 0.0004};
    RigidCount some{.name = "Studs", .meshes = 2, .instances = 1, .sheared = 2, .bent = 1};
    some.off = 0.001;
    some.off_bent = 0.02;
    EXPECT_THAT(sentences({all, some}, 0.001),
                ::testing::ElementsAre(
                    "Scales: 5 of its 5 tiles are instances, off by 0.0004 m at most",
                    "Studs, 2 meshes: 1 of its 4 tiles are instances, 2 are nodes with a matrix, "
                    "off by 0.001 m at most; 1 stays bent: instances would be off by more than "
                    "0.001 m, by up to "
                    "0.02 m"));
}

TEST(Instances, MakeFilesSmallAndLeaveOthersAsTheyWere)
{
    const Document document = studded();
    const Export plain = exported(document, {}), made = exported(document, 0.01);
    const std::string with = write_glb(made.model, {.instances = true}),
                      without = write_glb(plain.model);
    EXPECT_LT(with.size(), without.size());
    EXPECT_TRUE(holds(with, R"("extensionsUsed":["EXT_mesh_gpu_instancing"])"));
    EXPECT_FALSE(holds(without, "EXT_mesh_gpu_instancing"));
    // The nodes of all else are the same; those of the layer are the last ones.
    GlbContent a = glb_content_of(with, "a"), b = glb_content_of(without, "b");
    EXPECT_EQ(a.nodes.back().name, "Stud");
    const auto is_stud = [](const GlbContent::Node& node) { return node.name == "Stud"; };
    std::erase_if(a.nodes, is_stud);
    std::erase_if(b.nodes, is_stud);
    EXPECT_EQ(a.nodes, b.nodes);
}

TEST(Instances, OfACertifiedExportKeepTheClaimsOfTheOthers)
{
    const Document document = studded();
    const double tolerance = 1e-3;
    const Evaluation evaluated = shown(refined_to(document, tolerance));
    const Export plain = export_of(evaluated,
                                   {.document = document, .tolerance = tolerance, .log = {}}),
                 made = export_of(evaluated, {.document = document,
                                              .tolerance = tolerance,
                                              .log = {},
                                              .instances = tolerance});
    ASSERT_TRUE(made.certificate && plain.certificate);
    EXPECT_EQ(made.certificate->instances, tolerance);
    EXPECT_EQ(certificate_from_json(made.model.extras).instances, tolerance);
    EXPECT_FALSE(certificate_from_json(plain.model.extras).instances);
    EXPECT_EQ(made.certificate->result, plain.certificate->result);
    ASSERT_EQ(made.certificate->parts.size(), plain.certificate->parts.size());
    const GlbContent content = glb_content_of(write_glb(made.model, {.instances = true}), "a");
    for (std::size_t p = 0; p < plain.certificate->parts.size(); ++p) {
        const Certificate::PartClaim &a = made.certificate->parts[p],
                                     &b = plain.certificate->parts[p];
        EXPECT_EQ(a.bound, b.bound);
        EXPECT_EQ(a.triangles, b.triangles);
        EXPECT_EQ(content.nodes.at(static_cast<std::size_t>(a.node)).name, a.name);
        EXPECT_EQ(3 * a.triangles,
                  content.nodes.at(static_cast<std::size_t>(a.node)).corners.size());
    }
}

TEST(Instances, OfCopiesShareOneMeshAndKeepTheNamesOfObjects)
{
    Document document = after(Document(), AddBox{.name = "Box", .shape = {}, .transform = {}});
    document = after(document, Duplicate{.objects = {1}, .offset = {3, 0, 0}});
    const Export made = exported(document, 1e-3);
    const Model back = through_glb(made.model, true);
    EXPECT_EQ(back.meshes.size(), 1u);
    EXPECT_EQ(through_glb(made.model, false).meshes.size(), 2u);
    ASSERT_EQ(back.nodes.size(), 2u);
    EXPECT_NE(back.nodes[0].name, back.nodes[1].name);
}

// Returns the numbers between a name and the end of its list in a text of USD.
std::vector<float> usd_numbers(const std::string& text, const std::string& name, std::size_t from)
{
    const std::size_t at = text.find('[', text.find(name + " = [", from) + name.size());
    std::string list = text.substr(at + 1, text.find(']', at) - at - 1);
    for (char& c : list)
        if (c == '(' || c == ')' || c == ',') c = ' ';
    std::istringstream numbers(list);
    std::vector<float> out;
    for (float value; numbers >> value;) out.push_back(value);
    return out;
}

TEST(Instances, OfUsdArePointInstancersWithTheirPrototype)
{
    const TemporaryFolder folder;
    const Document document = studded();
    const auto written = [&](const std::string& name, bool instances) {
        return write_animated({.document = document,
                               .frames = {1, 1},
                               .tolerance = 0.01,
                               .log = {},
                               .instances = instances},
                              std::make_shared<const AssetStore>(""), folder.file(name));
    };
    EXPECT_TRUE(written("bent.usda", false).tiles.empty());
    EXPECT_THAT(written("a.usda", true).tiles,
                ::testing::ElementsAre(AllOf(HasSubstr("Stud: "), HasSubstr("are instances"))));
    const std::string bent = read_text_file(folder.file("bent.usda")),
                      text = read_text_file(folder.file("a.usda"));
    EXPECT_FALSE(holds(bent, "PointInstancer"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
    const std::size_t at = text.find("def PointInstancer \"Stud_");
    ASSERT_NE(at, std::string::npos);
    const std::string name = text.substr(at + 20, text.find('"', at + 20) - at - 20);
    EXPECT_TRUE(holds(text, "rel prototypes = </Scene/" + name + "/" + name + ">"));
    const std::size_t prototype = text.find("def Mesh \"" + name, at);
    ASSERT_NE(prototype, std::string::npos);
    const std::vector<float> unit = usd_numbers(text, "point3f[] points", prototype),
                             places = usd_numbers(text, "point3f[] positions", at),
                             turns = usd_numbers(text, "quath[] orientations", at),
                             scales = usd_numbers(text, "float3[] scales", at),
                             kinds = usd_numbers(text, "int[] protoIndices", at);
    const std::vector<float> truth =
        usd_numbers(bent, "point3f[] points", bent.find("def Mesh \"Stud_"));
    const std::size_t count = kinds.size(), vertices = unit.size() / 3;
    ASSERT_EQ(places.size(), 3 * count);
    ASSERT_EQ(turns.size(), 4 * count);
    ASSERT_EQ(scales.size(), 3 * count);
    ASSERT_EQ(truth.size(), 3 * count * vertices);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t v = 0; v < vertices; ++v) {
            const glm::vec3 u(unit[3 * v], unit[3 * v + 1], unit[3 * v + 2]),
                s(scales[3 * i], scales[3 * i + 1], scales[3 * i + 2]),
                t(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
            const glm::quat q(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
            const glm::vec3 p = t + glm::mat3_cast(q) * (s * u);
            const std::size_t k = 3 * (i * vertices + v);
            EXPECT_LT(glm::distance(p, glm::vec3(truth[k], truth[k + 1], truth[k + 2])), 0.0101);
        }
}

TEST(Instances, OfUsdLeaveAsMeshesWhatIsFurtherThanTheTolerance)
{
    const TemporaryFolder folder;
    Document document = studded();
    document.time = {.first_frame = 1, .last_frame = 3, .frames_per_second = 24};
    Animate grow;
    grow.of.push_back({stud,
                       {{.parameter = "tiles.height",
                         .keys = {{.frame = 1, .value = 1}, {.frame = 3, .value = 2}}}}});
    document = after(document, grow);
    const AnimatedFile made = write_animated(
        {.document = document, .frames = {1, 3}, .tolerance = 3.5e-3, .log = {}, .instances = true},
        std::make_shared<const AssetStore>(""), folder.file("a.usda"));
    const std::string text = read_text_file(folder.file("a.usda"));
    EXPECT_THAT(made.tiles, ::testing::ElementsAre(HasSubstr("stay bent")));
    for (const char* part : {"float3[] scales.timeSamples", "def Mesh \"Stud_"})
        EXPECT_TRUE(holds(text, part)) << part << " " << made.tiles.front();
}

TEST(Instances, OfUsdAreOneInstancerWhereTilesGrow)
{
    const TemporaryFolder folder;
    Document document = studded();
    document.time = {.first_frame = 1, .last_frame = 6, .frames_per_second = 24};
    Animate grow;
    grow.of.push_back({stud,
                       {{.parameter = "tiles.growth",
                         .keys = {{.frame = 1, .value = 0}, {.frame = 6, .value = 1}}}}});
    document = after(document, grow);
    const AnimatedFile made = write_animated(
        {.document = document, .frames = {1, 6}, .tolerance = 0.01, .log = {}, .instances = true},
        std::make_shared<const AssetStore>(""), folder.file("a.usda"));
    const std::string text = read_text_file(folder.file("a.usda"));
    const std::size_t first = text.find("def PointInstancer \"Stud_");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.find("def PointInstancer", first + 1), std::string::npos);
    EXPECT_FALSE(holds(text, "from frame"));
    // The file has as many instances at each time as the scene has then.
    const std::size_t kinds = text.find("int[] protoIndices.timeSamples", first);
    ASSERT_NE(kinds, std::string::npos);
    std::set<std::size_t> counts;
    for (int frame = 2; frame <= 6; ++frame) {
        const std::vector<Part> parts = shown(document, frame).objects.at(stud)->parts;
        const std::size_t count = parts.empty() ? 0 : parts.front().tiles->tiles->size();
        counts.insert(count);
        if (count == 0) continue;
        const std::size_t at = text.find(fmt::format("    {}: [", frame), kinds);
        const std::size_t end = text.find(']', at);
        EXPECT_EQ(std::count(text.begin() + static_cast<long>(at),
                             text.begin() + static_cast<long>(end), ','),
                  static_cast<long>(count) - 1)
            << frame;
    }
    EXPECT_GT(counts.size(), 2u);
    EXPECT_THAT(made.tiles,
                ::testing::ElementsAre(HasSubstr(fmt::format("{} of its {} tiles are instances",
                                                             *counts.rbegin(), *counts.rbegin()))));
}

TEST(Instances, AreInHalfPrecisionWhereUsdTurnsThem)
{
    NodeTransform parts;
    parts.rotation = glm::normalize(glm::dquat(0.3, 1e-6, -0.7, 0.1));
    const NodeTransform stored = in_usd_precision(parts);
    for (int c = 0; c < 4; ++c) {
        EXPECT_NEAR(stored.rotation[c], parts.rotation[c],
                    std::abs(parts.rotation[c]) / 2048 + 3e-8);
        EXPECT_EQ(std::ldexp(stored.rotation[c], 24),
                  std::round(std::ldexp(stored.rotation[c], 24)));
    }
    EXPECT_EQ(in_usd_precision({}), NodeTransform());
}

} // namespace
} // namespace trivar
