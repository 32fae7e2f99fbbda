// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "core/split/sever.h"
#include "core/split/split.h"
#include "tests/split/bodies.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace trivar::testing {
namespace {

constexpr double tube_at_x = 0.03, tube_radius = 0.16, tube_clearance = 0.01;

// The mesh with a fan in every hole. At each vertex of a border one border goes on.
Mesh without_holes(Mesh mesh)
{
    std::map<std::uint32_t, std::uint32_t> next; // along borders, the other way round than faces
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            edges.emplace(
                mesh.corners[c],
                mesh.corners[c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f]]);
    for (const auto& [a, b] : edges)
        if (!edges.contains({b, a})) next[b] = a;
    while (!next.empty()) {
        std::vector<std::uint32_t> loop{next.begin()->first};
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            loop.push_back(at->second);
            next.erase(at);
        }
        glm::dvec3 middle(0);
        for (std::size_t i = 1; i < loop.size(); ++i)
            middle += glm::dvec3(mesh.positions[loop[i]]) / static_cast<double>(loop.size() - 1);
        const auto center = static_cast<std::uint32_t>(mesh.vertex_count());
        mesh.positions.emplace_back(middle);
        for (std::size_t i = 1; i < loop.size(); ++i)
            add_face(mesh, std::array{loop[i - 1], loop[i], center});
    }
    return mesh;
}

// A real model, closed, its points at one place as one, upright and in a box of side 1 about the
// origin.
class RealDataSplit : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override
    {
        if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
        Mesh mesh = *read_model(real_data_folder() + "/meshes/" + GetParam()).meshes.front();
        const Box box = bounding_box(mesh);
        const glm::dvec3 middle = box.center(), size = box.size();
        const double side = std::max({size.x, size.y, size.z});
        for (glm::vec3& p : mesh.positions) p = glm::vec3((glm::dvec3(p) - middle) / side);
        Mesh bare;
        const std::vector<std::uint32_t> points = points_by_position(mesh.positions);
        bare.positions.resize(*std::ranges::max_element(points) + std::size_t{1});
        for (std::size_t v = 0; v < points.size(); ++v)
            bare.positions[points[v]] = mesh.positions[v];
        for (const glm::uvec3& t : triangles(mesh))
            add_face(bare, std::array{points[t.x], points[t.y], points[t.z]});
        model = without_holes(std::move(bare));
        ASSERT_EQ(closedness(model).open, 0u);
        ASSERT_EQ(closedness(model).twice, 0u);
    }
    Mesh at(double y) const
    {
        Mesh out = model;
        for (glm::vec3& p : out.positions) p.y += static_cast<float>(y);
        return out;
    }
    Mesh model;
};

// A tube along Z through the origin.
SplitField by_a_tube()
{
    const auto axis = [](double s) { return glm::dvec3(tube_at_x, 0, 3 * s - 1.5); };
    SplitObstacle out;
    out.name = "tube";
    out.bodies = {
        {std::make_shared<const RayMesh>(make_ref(bar(axis, tube_radius, 12))), glm::dmat4(1), 1}};
    out.clearance = tube_clearance;
    return split_field({out}, {});
}

} // namespace

TEST_P(RealDataSplit, StaysClosedAndClearWhileItPassesATube)
{
    const SplitField field = by_a_tube();
    std::size_t parted = 0, most = 0;
    double nearest = 1e300;
    for (int frame = 0; frame <= 24; ++frame) {
        SCOPED_TRACE(frame);
        const Mesh there = at(1.0 - frame / 12.0);
        const std::optional<SplitMesh> made = split(there, field, {.tolerance = 1e-3});
        if (!made) continue;
        ++parted;
        const Closedness after = closedness(made->mesh);
        EXPECT_EQ(after.open, 0u);
        EXPECT_EQ(after.twice, 0u);
        EXPECT_EQ(made->gaps, 0u);
        EXPECT_EQ(made->fans, 0u);
        EXPECT_LE(made->off, 1e-3);
        for (const glm::vec3& p : made->mesh.positions)
            nearest = std::min(nearest, glm::length(glm::dvec2(p.x - tube_at_x, p.y)));
        most = std::max(most, made->mesh.face_count());
    }
    EXPECT_GT(parted, 10u);
    EXPECT_GT(nearest, tube_radius); // its faces lie a little inside of that
    RecordProperty("parted", static_cast<int>(parted));
    RecordProperty("triangles", static_cast<int>(most));
    RecordProperty("nearest", std::to_string(nearest));
}

TEST_P(RealDataSplit, IsTheSameBeforeAndBehindATube)
{
    const SplitField field = by_a_tube();
    for (const double y : {-1.2, 1.2}) EXPECT_FALSE(split(at(y), field, {})); // nothing is moved
}

TEST_P(RealDataSplit, IsCutThroughItsCornersInClosedPiecesThatAddUp)
{
    std::mt19937 random(7);
    for (int round = 0; round < 12; ++round) {
        std::vector<Mesh> pieces{model};
        for (int k = 0; k < 3; ++k) { // three planes, one after the other
            const auto corner = [&] {
                return glm::dvec3(model.positions[random() % model.vertex_count()]);
            };
            const glm::dvec3 a = corner(), b = corner(), c = corner();
            if (!(glm::length(glm::cross(b - a, c - a)) > 1e-3)) continue;
            const CutSheet sheet({.point = a, .normal = glm::cross(b - a, c - a)}, glm::dmat4(1));
            std::vector<Mesh> next;
            for (Mesh& piece : pieces) {
                Unsevered where;
                std::optional<Severed> made = sever(piece, sheet, {}, where);
                if (!made) {
                    next.push_back(std::move(piece));
                    continue;
                }
                EXPECT_EQ(made->gaps + made->open, 0u);
                for (Mesh& half : made->halves) next.push_back(std::move(half));
            }
            pieces = std::move(next);
        }
        double sum = 0;
        for (const Mesh& piece : pieces) {
            EXPECT_EQ(closedness(piece).unequal, 0u);
            EXPECT_GT(volume(piece), 0);
            sum += volume(piece);
        }
        EXPECT_NEAR(sum, volume(model), 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataSplit,
                         ::testing::Values("stanford-bunny.obj", "spot.obj"));

} // namespace trivar::testing
