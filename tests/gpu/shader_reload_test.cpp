// SPDX-License-Identifier: GPL-3.0-or-later
// A developer's shaders: a copy of the checkout's is changed between two pictures.
#include "core/base/rejected.h"
#include "gpu/shader_folder.h"
#include "tests/gpu/support.h"
#include "tests/support/copied_shaders.h"
#include "tests/support/splines.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr, trivar::testing::CopiedShaders;

constexpr glm::ivec2 small_px{64, 48};

class ChangedShaders : public WithContext {
protected:
    ChangedShaders()
    {
        glDisable(GL_DEBUG_OUTPUT); // which would fail the test for what compilers say
        picture.instances.push_back(instance_of(box_mesh({2, 2, 2}, {1, 1, 1})));
        picture.camera.eye = {0, -6, 2};
        picture.samples = 1;
    }
    Image drawn()
    {
        picture.shaders = shaders.texts(time_s += 1);
        return renderer.render(picture, small_px);
    }
    const CopiedShaders copy;
    ShaderFolder shaders{copy.folder.path().string()};
    Renderer renderer;
    Picture picture;
    double time_s = 0;
};

TEST_F(ChangedShaders, AreDrawnWithAndTakenBack)
{
    const Image embedded = renderer.render(picture, small_px);
    EXPECT_EQ(drawn().rgba, embedded.rgba);
    const std::string own = "return saturate(c);", red = "return vec3(1.0, 0.0, 0.0);";
    copy.replace("tonemap.glsl", own, red); // which shade.frag includes
    EXPECT_EQ(rgb_at(drawn(), small_px / 2), glm::ivec3(255, 0, 0));
    copy.replace("tonemap.glsl", red, own);
    EXPECT_EQ(drawn().rgba, embedded.rgba);
    EXPECT_EQ(renderer.shader_trouble(), "");
}

TEST_F(ChangedShaders, ThatDoNotCompileLeaveThePictureAsItWasAndSayWhere)
{
    const Image before = drawn();
    const std::string line = "    c = max(c, 0.0)"; // the sixth
    copy.replace("tonemap.glsl", line, "    c = of nonsense;" + line);
    EXPECT_EQ(drawn().rgba, before.rgba);
    EXPECT_THAT(renderer.shader_trouble(),
                HasSubstr(" tonemap.glsl:6 (in shade.frag.glsl): syntax error"));
    copy.replace("tonemap.glsl", "    c = of nonsense;" + line, line);
    EXPECT_EQ(drawn().rgba, before.rgba);
    EXPECT_EQ(renderer.shader_trouble(), "");
}

TEST_F(ChangedShaders, ThatDoNotLinkLeaveThePictureAsItWas)
{
    const Image before = drawn();
    copy.replace("full.vert.glsl", "out vec2 uv;", "out vec2 vu;\n#define uv vu");
    EXPECT_EQ(drawn().rgba, before.rgba);
    EXPECT_THAT(renderer.shader_trouble(), HasSubstr("does not link full.vert.glsl"));
}

TEST_F(ChangedShaders, ThatIncludeWhatIsNowhereSaySo)
{
    const Image before = drawn();
    copy.replace("shade.frag.glsl", "tonemap.glsl", "toenmap.glsl");
    EXPECT_EQ(drawn().rgba, before.rgba);
    EXPECT_EQ(renderer.shader_trouble(),
              "shade.frag.glsl:4: there is no shader file toenmap.glsl.");
}

TEST_F(ChangedShaders, ThatNeverCompiledAreThoseOfTheProgramItself)
{
    const Image embedded = renderer.render(picture, small_px);
    for (const auto& file : fs::directory_iterator(copy.folder.path() / "gpu/shaders"))
        trivar::testing::write_file(file.path(), "nonsense;\n");
    Renderer fresh;
    picture.shaders = shaders.texts(1);
    EXPECT_EQ(fresh.render(picture, small_px).rgba, embedded.rgba);
    EXPECT_THAT(fresh.shader_trouble(), HasSubstr(".glsl:1"));
}

TEST_F(ChangedShaders, DeformAnewWhatTheyDeform)
{
    const Knots knots = Knots::uniform(3, 5);
    const Stage stage{
        make_ref(
            Lattice{trivar::testing::random_volume({knots, knots, knots}, 1, 0.1), glm::dmat4(1)}),
        {}};
    picture.instances.front().stages = {stage};
    picture.deform_by = DeformBy::two_phases;
    const Image before = drawn();
    const std::string old = "positions_out[at + 2u] = position.z;";
    copy.replace("vertex_buffers.glsl", old, "positions_out[at + 2u] = position.z + 1.0;");
    EXPECT_NE(drawn().rgba, before.rgba);
    copy.replace("vertex_buffers.glsl", "local_size_x", "nonsense");
    const Image kept = drawn();
    EXPECT_NE(kept.rgba, before.rgba);
    EXPECT_THAT(renderer.shader_trouble(),
                HasSubstr("vertex_buffers.glsl:3 (in deform.comp.glsl): "));
}

TEST(ShaderFolders, GiveOtherTextsOnlyWhereAFileChangedAndLookSeldom)
{
    const CopiedShaders copy;
    ShaderFolder shaders(copy.folder.path().string());
    const Ref<ShaderTexts> first = shaders.texts(1);
    EXPECT_EQ(shaders.texts(2), first);
    const fs::path file = copy.path("encode.glsl"); // another time stamp, the size as it was
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1));
    EXPECT_EQ(shaders.texts(2 + ShaderFolder::look_every_s / 2), first);
    const Ref<ShaderTexts> second = shaders.texts(3);
    EXPECT_NE(second, first);
    EXPECT_EQ(*second, *first);
    fs::remove(file);
    EXPECT_FALSE(shaders.texts(4)->contains("encode.glsl"));
}

TEST(ShaderFolders, RefuseWhatIsNoCheckout)
{
    const trivar::testing::TemporaryFolder folder;
    EXPECT_THROW(ShaderFolder(folder.path().string()), Rejected);
}

TEST(FirstErrors, AreFoundInWhatEveryDriverSays)
{
    const ShaderTexts texts{{"a.glsl", "one\n#include \"b.glsl\"\nfour\n"},
                            {"b.glsl", "two\nthree\n"}};
    const ShaderSource source = shader_source("a.glsl", {"X"}, &texts);
    EXPECT_EQ(source.text, "#version 430 core\n#define X\none\ntwo\nthree\nfour\n");
    EXPECT_EQ(first_error("0:4(1): warning: odd\n0:5(7): error: no such thing\n", source),
              "b.glsl:2 (in a.glsl): no such thing");
    EXPECT_EQ(first_error("ERROR: 0:6: 'four' : undeclared", source),
              "a.glsl:3: 'four' : undeclared");
    EXPECT_EQ(first_error("0(4) : error C1008: undefined variable", source),
              "b.glsl:1 (in a.glsl): C1008: undefined variable");
    EXPECT_EQ(first_error("error: without a place", source), "error: without a place");
    EXPECT_EQ(first_error("0:77(1): error: nowhere", source), "0:77(1): error: nowhere");
}

} // namespace
} // namespace trivar::gpu::testing
