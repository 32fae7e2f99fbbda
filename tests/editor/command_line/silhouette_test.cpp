// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/box.h"
#include "core/base/text.h"
#include "editor/command_line/command_line.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

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

// A volume of 48 x 48 x 120 samples with what belongs to them is larger than 1 MB.
TEST_F(SilhouetteCommandLine, DrawsTheSameLinesOfDataThatAreLargerThanMemory)
{
    VoxelGrid grid;
    grid.size = {48, 48, 120};
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < grid.size.z; ++k)
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i)
                samples.push_back(static_cast<std::uint8_t>(std::max(
                    0.0, 200 - 8 * glm::length(glm::dvec3(i - 23.5, j - 23.5, 0.4 * k - 23.7)))));
    grid.samples = std::move(samples);
    testing::write_file(volume_, write_nrrd(grid));
    const std::vector<std::string> level{"--level", "60.5", "--hidden", "dashed"};
    const Drawn whole = draw(level);
    EXPECT_THAT(whole.talk, Not(HasSubstr("slabs")));
    const std::string at_once = drawing();
    std::vector<std::string> small = level;
    small.insert(small.end(), {"--memory", "1"});
    const Drawn by_slabs = draw(small);
    EXPECT_EQ(by_slabs.status, Status::done) << by_slabs.talk;
    EXPECT_THAT(by_slabs.talk, HasSubstr("drawn in slabs of "));
    EXPECT_TRUE(drawing() == at_once);
    small.insert(small.end(), {"--crop", "0.25,0.25,0.48,0.75,0.75,0.52"});
    const Drawn box = draw(small);
    EXPECT_EQ(box.status, Status::done) << box.talk;
    EXPECT_THAT(box.talk, Not(HasSubstr("slabs")));
    small.emplace_back("--suggestive");
    small.erase(small.end() - 3, small.end() - 1);
    EXPECT_EQ(draw(small).status, Status::rejected);
}

TEST_F(SilhouetteCommandLine, FindsALevelItself)
{
    const Drawn drawn = draw({"--view", "0,0,1", "--fov", "40", "--hidden", "dashed"});
    EXPECT_EQ(drawn.status, Status::done) << drawn.talk;
    EXPECT_THAT(drawn.talk, HasSubstr(" of 1 level,"));
}

TEST_F(SilhouetteCommandLine, SaysWhichLevelItTook)
{
    const std::string said = "trivar: " + volume_ + ": level ";
    const Drawn drawn = draw({});
    ASSERT_THAT(drawn.talk, HasSubstr(said));
    EXPECT_THAT(drawn.talk, HasSubstr(" was taken, which parts the values best"));
    EXPECT_THAT(draw({"--level", "30.5"}).talk, Not(HasSubstr(said)));
}

// The box round the points of all paths of a drawing.
Box ink_of(const std::string& svg)
{
    Box out;
    for (std::size_t at = svg.find(" d=\"M"); at != svg.npos; at = svg.find(" d=\"M", at + 1)) {
        std::istringstream numbers(svg.substr(at + 5, svg.find('"', at + 5) - at - 5));
        for (glm::dvec3 p(0); numbers >> p.x >> p.y;) out.add(p);
    }
    return out;
}

TEST_F(SilhouetteCommandLine, FillsTheSheetWithWhatIsDrawn)
{
    // A ball of radius 4 in a corner of the grid.
    VoxelGrid grid;
    grid.size = glm::ivec3(40);
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < 40; ++k)
        for (int j = 0; j < 40; ++j)
            for (int i = 0; i < 40; ++i)
                samples.push_back(static_cast<std::uint8_t>(
                    std::max(0.0, 100 - 10 * glm::length(glm::dvec3(i, j, k) - 8.0))));
    grid.samples = samples;
    testing::write_file(volume_, write_nrrd(grid));
    for (const char* fov : {"", "40"}) {
        std::vector<std::string> options{"--level", "60.5", "--size", "400x400"};
        if (*fov) options.insert(options.end(), {"--fov", fov});
        ASSERT_EQ(draw(options).status, Status::done);
        const Box ink = ink_of(drawing());
        EXPECT_NEAR(ink.center().x, 200, 15) << fov;
        EXPECT_NEAR(ink.center().y, 200, 15) << fov;
        EXPECT_GT(ink.size().x, *fov ? 60 : 230);
        options.emplace_back("--frame-grid");
        ASSERT_EQ(draw(options).status, Status::done);
        EXPECT_LT(ink_of(drawing()).size().x, 100);
    }
}

TEST_F(SilhouetteCommandLine, DrawsStrokesThatAHandCanEditUnlessTheyTaper)
{
    draw({"--level", "30.5", "--crop", "0,0,0,0.6,1,1", "--hidden", "dashed"});
    EXPECT_THAT(drawing(), Not(HasSubstr("fill=\"#0")));
    draw({"--level", "30.5", "--crop", "0,0,0,0.6,1,1", "--taper", "12"});
    EXPECT_THAT(drawing(), HasSubstr("fill=\"#0"));
    draw({"--level", "30.5", "--crop", "0,0,0,0.6,1,1", "--taper", "0"});
    EXPECT_THAT(drawing(), Not(HasSubstr("fill=\"#0")));
    EXPECT_EQ(draw({"--taper", "-1"}).status, Status::usage);
}

TEST_F(SilhouetteCommandLine, TakesDistancesThatAFileWithoutAHeadDoesNotSay)
{
    volume_ = folder_.file("ball_24x24x24_u8.raw");
    std::string samples;
    for (int k = 0; k < 24; ++k)
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i)
                samples.push_back(static_cast<char>(
                    std::max(0.0, 100 - 10 * glm::length(glm::dvec3(i, j, k) - 11.5))));
    testing::write_file(volume_, samples);
    const Drawn plain = draw({"--level", "30.5", "--view", "0,1,0"});
    EXPECT_THAT(plain.talk,
                HasSubstr("it does not say how far its samples are apart; 1 mm was taken"));
    EXPECT_NEAR(ink_of(drawing()).size().x, ink_of(drawing()).size().y, 5);
    const Drawn told = draw({"--level", "30.5", "--view", "0,1,0", "--spacing", "0.5,0.5,2"});
    EXPECT_EQ(told.status, Status::done);
    EXPECT_THAT(told.talk, Not(HasSubstr("1 mm was taken")));
    EXPECT_NEAR(ink_of(drawing()).size().y / ink_of(drawing()).size().x, 4, 0.1);
    EXPECT_EQ(draw({"--spacing", "1,2"}).status, Status::usage);
    EXPECT_EQ(draw({"--spacing", "1,0,1"}).status, Status::usage);
}

TEST_F(SilhouetteCommandLine, DrawsALevelForEachSegmentOfALabelMap)
{
    std::string labels;
    for (int k = 0; k < 12; ++k)
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 12; ++i) {
                const double far = glm::length(glm::dvec3(i, j, k) - 5.5);
                labels.push_back(far < 2.5 ? '\2' : far < 4.5 ? '\1' : '\0');
            }
    volume_ = folder_.file("a.seg.nrrd");
    testing::write_file(volume_, "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 12 12 12\n"
                                 "spacings: 1 1 1\nencoding: raw\nSegment0_Name:=bone\n"
                                 "Segment0_LabelValue:=1\nSegment1_Name:=marrow\n"
                                 "Segment1_LabelValue:=2\n\n" +
                                     labels);
    const Drawn drawn = draw({"--hidden", "dashed"});
    EXPECT_THAT(drawn.talk, HasSubstr(" lines of 2 levels"));
    EXPECT_THAT(drawn.talk, HasSubstr("its segments are drawn as levels"));
    EXPECT_THAT(drawing(), HasSubstr("bone"));
    EXPECT_THAT(drawing(), HasSubstr("marrow"));
}

TEST_F(SilhouetteCommandLine, KeepsWhatAHandDidThroughManyDrawings)
{
    const std::vector<std::string> levels{"--level", "30.5,60.5"};
    draw(levels);
    std::string text = drawing();
    const std::size_t first = text.find("<path id=\"level-1-s");
    ASSERT_NE(first, text.npos);
    text.erase(first, text.find('\n', first) - first);
    text.insert(text.rfind("</svg>"), "<path d=\"M0 0 1 1\"/>");
    testing::write_file(out_, text);
    std::vector<std::string> again = levels;
    again.insert(again.end(), {"--edited", out_});
    for (int i = 0; i < 3; ++i) {
        const Drawn drawn = draw(again);
        EXPECT_THAT(drawn.talk, HasSubstr("1 edit by hand was done again"));
        EXPECT_THAT(drawn.talk, HasSubstr("1 element of the hand's own kept"));
        EXPECT_THAT(drawing(), HasSubstr("<path d=\"M0 0 1 1\"/></svg>"));
        EXPECT_THAT(drawing(), Not(HasSubstr("<path id=\"level-1-s")));
        EXPECT_THAT(drawing(), HasSubstr("<path id=\"level-2-s"));
    }
    again.insert(again.end(), {"--name", "a,b"});
    EXPECT_THAT(draw(again).talk, HasSubstr("1 is of a line not drawn here (no layer is called "
                                            "level-1)"));
}

TEST_F(SilhouetteCommandLine, ProvesNothingThatIsNotSo)
{
    const Drawn dashes = draw({"--dashes", "64", "--certified", "2"});
    EXPECT_EQ(dashes.status, Status::usage);
    EXPECT_THAT(dashes.talk, HasSubstr("have no proof"));
    const Drawn share = draw({"--level", "30.5", "--amount", "0.2", "--certified", "2"});
    EXPECT_THAT(share.talk, HasSubstr("before a share of the lines was taken, nothing larger"));
    EXPECT_THAT(share.talk, HasSubstr("0 loose ends"));
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
