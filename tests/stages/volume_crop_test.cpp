// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/casting/casting.h"
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/voxels.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/stages/shown_volume.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

// A ball of values from 100 in its middle, in 21 x 21 x 21 samples one millimetre apart.
class CroppedDocuments : public ::testing::Test {
protected:
    CroppedDocuments()
    {
        VoxelGrid grid;
        grid.size = glm::ivec3(21);
        std::vector<std::uint8_t> samples;
        for (int k = 0; k < 21; ++k)
            for (int j = 0; j < 21; ++j)
                for (int i = 0; i < 21; ++i)
                    samples.push_back(static_cast<std::uint8_t>(
                        std::max(0.0, 100 - 10 * glm::length(glm::dvec3(i, j, k) - 10.0))));
        grid.samples = samples;
        grid.to_metres = glm::dmat4(glm::dmat3(0.001));
        testing::write_file(folder_.file("ball.nrrd"), write_nrrd(grid));
        shape_.path = "ball.nrrd";
        shape_.levels = {{.value = 30.5}};
    }
    Document with(const VoxelShape& shape) const { return after({}, AddVoxels{.shape = shape}); }
    VoxelShape cropped_at(const glm::vec3& low, const glm::vec3& high = glm::vec3(1)) const
    {
        VoxelShape out = shape_;
        out.crop_low = low;
        out.crop_high = high;
        return out;
    }
    Ref<EvaluatedObject> shown(const VoxelShape& shape)
    {
        return evaluate_(with(shape), 1).objects.at(1);
    }
    testing::TemporaryFolder folder_;
    VoxelShape shape_;
    Evaluator evaluate_{std::make_shared<AssetStore>(folder_.path())};
};

TEST_F(CroppedDocuments, AreCountedByTheirDigestOnlyWhereSomethingIsCutOff)
{
    EXPECT_EQ(digest(with(shape_)), digest(with(cropped_at(glm::vec3(0)))));
    EXPECT_NE(digest(with(shape_)), digest(with(cropped_at({0.5f, 0, 0}))));
    EXPECT_NE(digest(with(shape_)), digest(with(cropped_at(glm::vec3(0), {1, 0.5f, 1}))));
}

TEST_F(CroppedDocuments, CutSurfacesLinesAndCastingAtOnePlane)
{
    shape_.casting.shown = true;
    const Ref<EvaluatedObject> object = shown(cropped_at({0.52f, 0, 0}, {1, 1, 0.7f}));
    const ShownVolume& volume = *object->shape->volume;
    EXPECT_EQ(volume.part, (SampleBox{{10, 0, 0}, {20, 20, 14}}));
    Box surface, cast, lines;
    for (const Part& part : object->parts)
        for (const glm::vec3& p : part.rest->positions) surface.add(glm::dvec3(p));
    for (const glm::vec3& p : volume.levels[0].mesh->positions)
        lines.add(glm::dvec3(volume.to_model * glm::dvec4(p, 1)));
    for (const glm::dvec3& p : volume.cast_box().corners())
        cast.add(glm::dvec3(volume.all_to_model() * glm::dvec4(p, 1)));
    for (const Box& box : {surface, lines, cast}) {
        EXPECT_NEAR(box.lo.x, 0.010, 1e-9);
        EXPECT_NEAR(box.hi.z, 0.014, 1e-8);
    }
    EXPECT_NEAR(surface.hi.x, lines.hi.x, 1e-9);
    EXPECT_NEAR(object->bounds->lo.x, 0.010, 1e-9);
    EXPECT_NEAR(object->bounds->hi.z, 0.014, 1e-9);
    EXPECT_NEAR(object->bounds->hi.x, 0.020, 1e-9);
}

TEST_F(CroppedDocuments, AreClosedByTheFacesOfTheBox)
{
    const Ref<EvaluatedObject> object = shown(cropped_at({0.5f, 0, 0}));
    const Mesh& mesh = *object->parts.at(0).rest;
    double volume = 0; // by the divergence theorem
    for (std::size_t f = 0; f + 1 < mesh.face_begin.size(); ++f)
        for (std::uint32_t c = mesh.face_begin[f] + 2; c < mesh.face_begin[f + 1]; ++c) {
            const glm::dvec3 a(mesh.positions[mesh.corners[mesh.face_begin[f]]]),
                b(mesh.positions[mesh.corners[c - 1]]), d(mesh.positions[mesh.corners[c]]);
            volume += glm::dot(a, glm::cross(b, d)) / 6;
        }
    const double radius = 0.00695; // of the level
    EXPECT_NEAR(volume, 2.0 / 3 * 3.14159 * radius * radius * radius, 0.03 * 7e-7);
}

TEST_F(CroppedDocuments, KeepTheFunctionAndWhatIsReadyForRays)
{
    shape_.casting.shown = true;
    const Ref<EvaluatedObject> whole = shown(shape_), half = shown(cropped_at({0.5f, 0, 0}));
    const ShownVolume &a = *whole->shape->volume, &b = *half->shape->volume;
    EXPECT_EQ(a.casting, b.casting);
    EXPECT_EQ(a.casting->field, a.field) << "what is not cropped is not copied";
    EXPECT_EQ(a.summary, b.summary) << "the histogram is that of all data";
    EXPECT_EQ(b.field->field().at<0>(1.5f, 3, 4).value, a.field->field().at<0>(11.5f, 3, 4).value);
}

TEST_F(CroppedDocuments, ShowNothingOfABoxThatKeysHaveClosed)
{
    shape_.casting.shown = true;
    const Document document = after(with(cropped_at({0.2f, 0, 0})),
                                    Animate{{{1, {{"shape.crop_low.x", {{1, 0.2}, {10, 1}}}}}}});
    EXPECT_FALSE(evaluate_(document, 1).objects.at(1)->bounds->empty());
    const Ref<EvaluatedObject> closed = evaluate_(document, 10).objects.at(1);
    EXPECT_TRUE(closed->shape->volume->levels.empty());
    EXPECT_TRUE(closed->shape->volume->cast_box().empty());
    EXPECT_TRUE(closed->bounds->empty());
}

TEST_F(CroppedDocuments, TakeKeysAndRefuseABoxWithoutAnInside)
{
    std::vector<std::string> names;
    for (const Parameter& each : parameters(*with(shape_).objects.at(1)))
        names.push_back(each.name);
    EXPECT_THAT(names, ::testing::IsSupersetOf({"shape.crop_low.x", "shape.crop_high.z"}));
    EXPECT_THROW(with(cropped_at({0, 0.6f, 0}, {1, 0.6f, 1})), Rejected);
}

} // namespace
} // namespace trivar
