// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/picture_selection.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

gpu::Picture picture_of_three()
{
    gpu::Picture picture;
    for (const int id : {1, 2}) {
        gpu::Instance instance;
        instance.id = id;
        picture.instances.push_back(instance);
    }
    picture.instances[1].copies =
        make_ref(std::vector<gpu::Copy>{{.id = 0}, {.id = 5}, {.id = 6}, {.id = 5}});
    picture.curves = {{.id = 3}};
    return picture;
}

TEST(PictureSelection, OutlinesInstancesCurvesAndSingleCopies)
{
    const Document document;
    gpu::Picture picture = picture_of_three();
    outline_selected(picture, Members(document, {3, 5}));
    EXPECT_FALSE(picture.instances[0].highlighted);
    EXPECT_FALSE(picture.instances[1].highlighted);
    EXPECT_EQ(picture.instances[1].outlined_copies, (std::vector<std::uint32_t>{1, 3}));
    EXPECT_TRUE(picture.curves[0].highlighted);
    outline_selected(picture, Members(document, {2}));
    EXPECT_TRUE(picture.instances[1].highlighted);
    EXPECT_TRUE(picture.instances[1].outlined_copies.empty()) << "all have one";
    EXPECT_FALSE(picture.curves[0].highlighted);
}

TEST(PictureSelection, OutlinesCurvesAloneMoreThinly)
{
    const Document document;
    gpu::Picture picture = picture_of_three();
    outline_selected(picture, Members(document, {1, 3}));
    EXPECT_EQ(outline_for(picture, {.width_px = 2}).width_px, 2);
    outline_selected(picture, Members(document, {3}));
    EXPECT_EQ(outline_for(picture, {.width_px = 2}).width_px, 1);
}

TEST(PictureSelection, LeavesOutInstancesCurvesAndVolumes)
{
    gpu::Picture picture = picture_of_three();
    picture.volumes = {{.id = 4}, {.id = 5}};
    leave_out(picture, {1, 3, 4});
    ASSERT_EQ(picture.volumes.size(), 1u);
    EXPECT_EQ(picture.volumes[0].id, 5);
    ASSERT_EQ(picture.instances.size(), 1u);
    EXPECT_EQ(picture.instances[0].id, 2);
    EXPECT_TRUE(picture.curves.empty());
}

} // namespace
} // namespace trivar
