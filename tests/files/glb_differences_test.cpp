// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_differences.h"

#include "core/base/rejected.h"
#include "core/files/gltf/glb_chunks.h"
#include "tests/files/curves.h"
#include "tests/files/sample_models.h"

#include <cstring>
#include <functional>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty, ::testing::SizeIs;
using AnyJson = nlohmann::json;

const std::string& written()
{
    static const std::string bytes = write_glb(testing::box_model());
    return bytes;
}

std::vector<std::string> differences_with(const std::function<void(AnyJson&)>& change)
{
    GlbChunks chunks = glb_chunks(written());
    AnyJson file = AnyJson::parse(chunks.json);
    change(file);
    chunks.json = file.dump(1);
    return glb_differences(glb_container(chunks), written());
}

TEST(GlbDifferences, AreNoneHoweverTheJsonIsSpaced)
{
    EXPECT_THAT(glb_differences(written(), written()), IsEmpty());
    EXPECT_THAT(differences_with([](AnyJson&) {}), IsEmpty());
    EXPECT_THAT(differences_with([](AnyJson& file) { file["extras"]["any"] = 1; }), IsEmpty());
}

TEST(GlbDifferences, TellOfPointsOfCurvesThatWereMoved)
{
    const std::string wires = write_glb(testing::curves_model());
    EXPECT_THAT(glb_differences(wires, wires), IsEmpty());
    Model moved = testing::curves_model();
    Curves curves = *moved.curves[0];
    Mesh points = *curves.points;
    points.positions[2].y = 0.5f;
    curves.points = make_ref(std::move(points));
    moved.curves[0] = make_ref(std::move(curves));
    EXPECT_THAT(glb_differences(write_glb(moved), wires),
                ::testing::Contains(HasSubstr("POSITION")));
}

TEST(GlbDifferences, NameWhatIsNotThePlainForm)
{
    const auto says = [](const char* sentence, const std::function<void(AnyJson&)>& change) {
        const std::vector<std::string> found = differences_with(change);
        ASSERT_THAT(found, SizeIs(1)) << sentence;
        EXPECT_THAT(found[0], HasSubstr(sentence));
    };
    const AnyJson some{{{"any", 1}}};
    says("it has \"animations\"", [&](AnyJson& file) { file["animations"] = some; });
    says("it has \"skins\"", [&](AnyJson& file) { file["skins"] = some; });
    says("its nodes[0] has \"skin\"", [](AnyJson& file) { file["nodes"][0]["skin"] = 0; });
    says("its nodes[0] has \"scale\"", [](AnyJson& file) {
        file["nodes"][0]["scale"] = {2, 2, 2};
    });
    says("its nodes[0].matrix[12] is 3.0, the scene gives 0.0",
         [](AnyJson& file) { file["nodes"][0]["matrix"][12] = 3.0; });
    says("its nodes has 2 entries, the scene gives 1",
         [](AnyJson& file) { file["nodes"].push_back(file["nodes"][0]); });
    says("its scenes[0].nodes has 0 entries, the scene gives 1",
         [](AnyJson& file) { file["scenes"][0]["nodes"] = AnyJson::array(); });
    says("its scene is 1, the scene gives 0", [](AnyJson& file) { file["scene"] = 1; });
    says("its meshes[0] has \"weights\"",
         [](AnyJson& file) { file["meshes"][0]["weights"] = {1}; });
    says("its meshes[0].primitives[1] has \"targets\"",
         [&](AnyJson& file) { file["meshes"][0]["primitives"][1]["targets"] = some; });
    says("its meshes[0].primitives[0] has \"mode\"",
         [](AnyJson& file) { file["meshes"][0]["primitives"][0]["mode"] = 1; });
    says("its accessors[0] has \"sparse\"",
         [&](AnyJson& file) { file["accessors"][0]["sparse"] = some; });
    says("its accessors[0] has \"byteOffset\"",
         [](AnyJson& file) { file["accessors"][0]["byteOffset"] = 12; });
    says("its accessors[0].componentType is 5122",
         [](AnyJson& file) { file["accessors"][0]["componentType"] = 5122; });
    says("its bufferViews[0] has \"byteStride\"",
         [](AnyJson& file) { file["bufferViews"][0]["byteStride"] = 24; });
    says("its materials[1].alphaMode is \"MASK\"",
         [](AnyJson& file) { file["materials"][1]["alphaMode"] = "MASK"; });
    says("it has no meshes", [](AnyJson& file) { file.erase("meshes"); });
}

TEST(GlbDifferences, CountTheNumbersThatAreOthers)
{
    const auto with = [](int view, float add) {
        GlbChunks chunks = glb_chunks(written());
        const auto at =
            AnyJson::parse(chunks.json)["bufferViews"][static_cast<std::size_t>(view)]["byteOffset"]
                .get<std::size_t>();
        float value;
        std::memcpy(&value, chunks.binary.data() + at, 4);
        value += add;
        std::memcpy(chunks.binary.data() + at, &value, 4);
        return glb_differences(glb_container(chunks), written());
    };
    EXPECT_THAT(with(1, 1e-7f), IsEmpty()); // the views are the image, positions, normals ...
    ASSERT_THAT(with(1, 1e-4f), SizeIs(1));
    EXPECT_THAT(with(1, 1e-4f)[0], HasSubstr("box's POSITION are not the scene's"));
    EXPECT_THAT(with(2, 1e-4f)[0], HasSubstr("1 of the"));
    EXPECT_THAT(with(2, 1e-4f)[0], HasSubstr("box's NORMAL"));
    EXPECT_THAT(with(2, std::numeric_limits<float>::quiet_NaN()), SizeIs(1));
    EXPECT_THAT(with(0, 1)[0], HasSubstr("its image checker is another"));
}

TEST(GlbDifferences, AreFoundInTheContainerToo)
{
    EXPECT_THAT(glb_differences(written() + "more", written()),
                ::testing::Contains(HasSubstr("not two chunks")));
    GlbChunks chunks = glb_chunks(written());
    chunks.json.insert(1, R"("nodes":[],)"); // a program may take the first, another the last
    EXPECT_THROW(glb_differences(glb_container(chunks), written()), Rejected);
    chunks.json = "[1]";
    EXPECT_THAT(glb_differences(glb_container(chunks), written()), SizeIs(1));
    chunks.json = "{";
    EXPECT_THROW(glb_differences(glb_container(chunks), written()), Rejected);
    EXPECT_THROW(glb_differences("glTF", written()), Rejected);
}

} // namespace
} // namespace trivar
