// SPDX-License-Identifier: GPL-3.0-or-later
// What is written can be read.
#include "core/files/write_model.h"

#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

class WhatIsWritten : public ::testing::TestWithParam<const char*> {
protected:
    std::string refusal(const Model& model) const
    {
        std::filesystem::remove(file_);
        try {
            write_model(model, file_);
        } catch (const Rejected& rejected) {
            EXPECT_FALSE(std::filesystem::exists(file_));
            return rejected.what();
        }
        read_model(file_);
        return "";
    }

private:
    TemporaryFolder folder_;
    std::string file_ = folder_.file(std::string("model") + GetParam());
};

TEST_P(WhatIsWritten, HasAFace)
{
    EXPECT_THAT(refusal(single_mesh_model("nothing", Mesh())), HasSubstr("so nothing is written"));
    Model unnamed = box_model();
    unnamed.nodes.clear();
    EXPECT_THAT(refusal(unnamed), HasSubstr("so nothing is written"));
    Mesh line;
    line.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    add_face(line, std::array<std::uint32_t, 3>{0, 1, 2});
    line.normals.assign(3, {0, 0, 1});
    EXPECT_THAT(refusal(single_mesh_model("line", line)), HasSubstr("so nothing is written"));
}

TEST_P(WhatIsWritten, IsRefusedWhereItsPlaceTakesAllOfIt)
{
    Model model = box_model();
    model.nodes[0].to_parent = glm::scale(glm::dmat4(1), glm::dvec3(0));
    const std::string why = refusal(model);
    EXPECT_EQ(why.empty(), std::string(GetParam()) == ".glb") << why;
}
INSTANTIATE_TEST_SUITE_P(Formats, WhatIsWritten,
                         ::testing::Values(".glb", ".obj", ".ply", ".stl", ".off"));

} // namespace
} // namespace trivar
