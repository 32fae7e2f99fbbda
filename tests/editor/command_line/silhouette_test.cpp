// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/voxels/volume_writers.h"
#include "editor/command_line/command_line.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Drawn {
    Status status;
    std::string talk;
};

class SilhouetteCommandLine : public ::testing::Test {
protected:
    // A ball of values from 100 in the middle to 0 at its border, in a folder of its own.
    SilhouetteCommandLine()
    {
        constexpr int n = 24;
        std::vector<std::uint8_t> samples;
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    samples.push_back(static_cast<std::uint8_t>(
                        std::max(0.0, 100 - 10 * glm::length(glm::dvec3(i, j, k) - 11.5))));
        VoxelGrid grid;
        grid.size = glm::ivec3(n);
        grid.samples = samples;
        testing::write_file(volume_, write_nrrd(grid));
    }
    Drawn draw(std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"silhouette", volume_, "--out", out_});
        std::ostringstream out, talk;
        const Status status = run_program(options, {out, talk});
        return {status, talk.str()};
    }
    std::string drawing() const { return read_text_file(out_); }

    testing::TemporaryFolder folder_;
    std::string volume_ = folder_.file("ball.nrrd"), out_ = folder_.file("ball.svg");
};

TEST_F(SilhouetteCommandLine, DrawsALayerForEachLevel)
{
    const Drawn drawn = draw({"--level", "30.5,60.5", "--certified", "2"});
    EXPECT_EQ(drawn.status, Status::done) << drawn.talk;
    EXPECT_THAT(drawn.talk, HasSubstr("2 lines of 2 levels"));
    EXPECT_THAT(drawn.talk, HasSubstr("nothing larger than 1/4 voxel is missing"));
    EXPECT_THAT(drawing(), HasSubstr("level 1"));
    EXPECT_THAT(drawing(), HasSubstr("level 2"));
}

TEST_F(SilhouetteCommandLine, DrawsWhatIsInABox)
{
    const Drawn drawn = draw({"--level", "30.5", "--crop", "0.5,0,0,1,1,1"});
    EXPECT_EQ(drawn.status, Status::done) << drawn.talk;
    EXPECT_THAT(drawing(), HasSubstr("level 1"));
    EXPECT_EQ(draw({"--crop", "0.5,0,0,0.4,1,1"}).status, Status::usage);
    EXPECT_EQ(draw({"--crop", "0.5"}).status, Status::usage);
    EXPECT_EQ(draw({"--crop", "0,0,0,1,1,1.5"}).status, Status::usage);
}

TEST_F(SilhouetteCommandLine, FindsALevelItself)
{
    const Drawn drawn = draw({"--view", "0,0,1", "--fov", "40", "--hidden", "dashed"});
    EXPECT_EQ(drawn.status, Status::done) << drawn.talk;
    EXPECT_THAT(drawn.talk, HasSubstr(" of 1 level,"));
}

TEST_F(SilhouetteCommandLine, SaysWhatIsWrong)
{
    EXPECT_EQ(draw({"--hidden", "some"}).status, Status::usage);
    EXPECT_THAT(draw({"--hidden", "some"}).talk, HasSubstr("none, faint, dashed, seen"));
    EXPECT_EQ(draw({"--view", "0,0,0"}).status, Status::usage);
    EXPECT_EQ(draw({"--view", "1,2"}).status, Status::usage);
    EXPECT_EQ(draw({"--view", "0,0,1", "--up", "0,0,1"}).status, Status::usage);
    EXPECT_THAT(draw({"--level", "900"}).talk, HasSubstr("no line is seen"));
    testing::write_file(volume_, "NRRD0004\nencoding: raw\n");
    const Drawn damaged = draw({});
    EXPECT_EQ(damaged.status, Status::rejected);
    EXPECT_THAT(damaged.talk, Not(IsEmpty()));
}

} // namespace
} // namespace trivar
