// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/objects/voxels.h"
#include "core/document/document_digest.h"
#include "core/document/drawn_lines.h"
#include "core/evaluation/evaluate.h"
#include "core/stages/shown_volume.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

constexpr int per_axis = 21;
constexpr double ball_radius = 6.3; // of a ball of 200 amid 20, in voxels of a millimetre

class FittedDocuments : public ::testing::Test {
protected:
    FittedDocuments()
    {
        VoxelGrid grid;
        grid.size = glm::ivec3(per_axis);
        std::vector<std::uint8_t> samples;
        for (int k = 0; k < per_axis; ++k)
            for (int j = 0; j < per_axis; ++j)
                for (int i = 0; i < per_axis; ++i) {
                    const double off = ball_radius - glm::length(glm::dvec3(i, j, k) - 10.0);
                    samples.push_back(
                        static_cast<std::uint8_t>(110 + 90 * std::clamp(off, -1.0, 1.0)));
                }
        grid.samples = samples;
        grid.to_metres = glm::dmat4(glm::dmat3(0.001));
        testing::write_file(folder_.file("ball.nrrd"), write_nrrd(grid));
        shape_.path = "ball.nrrd";
        shape_.levels = {{.value = 110, .surface = false, .lines = true}};
    }
    Ref<EvaluatedObject> shown(const TetrahedraFit& fit)
    {
        VoxelShape shape = shape_;
        shape.fit = fit;
        document_ = after({}, AddVoxels{.shape = shape});
        return evaluate_(document_, 1).objects.at(1);
    }
    testing::TemporaryFolder folder_;
    VoxelShape shape_;
    Document document_;
    Evaluator evaluate_{std::make_shared<AssetStore>(folder_.path())};
};

TEST_F(FittedDocuments, HaveTheSurfaceOfTheFitInPlaceOfTheSplines)
{
    const Ref<EvaluatedObject> plain = shown({});
    EXPECT_TRUE(plain->shape->volume->levels.at(0).lines);
    EXPECT_FALSE(drawn_lines(*document_.objects.at(1)));
    const Ref<EvaluatedObject> fitted = shown({.coefficients = 700, .degree = 1, .boundary = 110});
    EXPECT_FALSE(fitted->shape->volume->levels.at(0).lines);
    ASSERT_TRUE(drawn_lines(*document_.objects.at(1)));
    EXPECT_FALSE(drawn_lines(*document_.objects.at(1))->surface);
    const Mesh& mesh = *fitted->shape->model->meshes.at(0);
    ASSERT_GT(mesh.face_count(), 500U);
    for (const glm::vec3& p : mesh.positions)
        EXPECT_NEAR(glm::length(glm::dvec3(p) * 1e3 - 10.0), ball_radius, 0.35);
}

TEST_F(FittedDocuments, ShowTheSplineAndSayWhyWhereThereIsNoFit)
{
    const Ref<EvaluatedObject> refused =
        shown({.coefficients = 700, .degree = 1, .boundary = 5000});
    EXPECT_THAT(refused->shape->notices,
                ::testing::Contains(::testing::HasSubstr("not fitted by tetrahedra")));
    EXPECT_TRUE(refused->shape->volume->levels.at(0).lines);
}

TEST_F(FittedDocuments, AreCountedByTheirDigest)
{
    shown({});
    const auto plain = digest(document_);
    shown({.coefficients = 700});
    EXPECT_NE(digest(document_), plain);
}

} // namespace
} // namespace trivar
