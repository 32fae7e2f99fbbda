// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/text_models.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// The same faces, with a vertex that none of them uses before the vertex `at`.
TextModel with_loose_vertex(TextModel model, std::size_t at, const std::string& position)
{
    model.vertices.insert(model.vertices.begin() + static_cast<std::ptrdiff_t>(at), position);
    for (auto& face : model.faces)
        for (int& v : face) v += static_cast<std::size_t>(v) >= at ? 1 : 0;
    return model;
}

class FormatsWithVertices : public ::testing::TestWithParam<const char*> {};

TEST_P(FormatsWithVertices, GiveTheSameMeshWithLooseVerticesAnywhere)
{
    // The square's corner 1 1 0 stands there twice, as at a seam.
    TextModel seam = square_model();
    seam.vertices.push_back("1 1 0");
    seam.faces[1][1] = 4;
    for (const TextModel& model : {square_model(), seam}) {
        const Mesh expected = *read_text_model(text_of(model, GetParam()), GetParam()).meshes[0];
        for (std::size_t at = 0; at <= model.vertices.size(); ++at)
            for (const char* position : {"9 9 9", "1 1 0", "0 0 0"}) {
                const TextModel loose =
                    with_loose_vertex(with_loose_vertex(model, at, position), at / 2, "-3 1 0");
                const Model read = read_text_model(text_of(loose, GetParam()), GetParam());
                EXPECT_EQ(*read.meshes[0], expected) << at << " " << position;
                // An OBJ's are a store that its faces take from.
                EXPECT_EQ(read.notices.size(), GetParam() == std::string(".obj") ? 0u : 1u);
            }
    }
}
INSTANTIATE_TEST_SUITE_P(Formats, FormatsWithVertices, ::testing::Values(".obj", ".ply", ".off"));

TEST(SignedZeros, AreOnePlaceInEveryFormat)
{
    for (const std::string extension : {".ply", ".off", ".stl"}) {
        TextModel model = square_model();
        model.vertices.push_back("-0 0 -0.0");
        model.faces[1][0] = 4;
        const Mesh mesh = *read_text_model(text_of(model, extension), extension).meshes[0];
        EXPECT_EQ(point_count(mesh), 4u) << extension;
    }
}

TEST(Scale, ThatLeavesTheNumbersThereAreIsRefused)
{
    const std::string text = obj_text({{"3e38 0 0", "0 3e38 0", "0 0 0"}, {{0, 1, 2}}});
    EXPECT_EQ(read_model_bytes(text, "a.obj", "").meshes[0]->face_count(), 1u);
    try {
        read_model_bytes(text, "a.obj", "", {.scale = 1000});
        ADD_FAILURE();
    } catch (const Rejected& rejected) {
        EXPECT_EQ(std::string(rejected.what()), "a.obj: the scale 1000 makes it larger than "
                                                "numbers can say (3.4e38); choose a smaller scale");
    }
}

} // namespace
} // namespace trivar
