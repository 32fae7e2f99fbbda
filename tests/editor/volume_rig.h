// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/voxels.h"
#include "core/files/pictures/image.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <string>

namespace trivar::testing {

// A ball of values from 100 in the middle to 0 at its border; of 3 cm.
inline VoxelGrid ball_grid(int n = 24)
{
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                samples.push_back(static_cast<std::uint8_t>(std::max(
                    0.0, 100 - 240.0 / n * glm::length(glm::dvec3(i, j, k) - (n - 1) / 2.0))));
    VoxelGrid grid;
    grid.size = glm::ivec3(n);
    grid.samples = samples;
    grid.to_metres = glm::dmat4(glm::dmat3(0.03 / n));
    return grid;
}

// The same as the grey pictures of a folder.
inline void write_slices(const std::string& folder, int n = 12)
{
    const VoxelGrid grid = ball_grid(n);
    const auto& samples = std::get<std::vector<std::uint8_t>>(grid.samples);
    const auto plane = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    write_file(folder + "/about.txt", "not a slice");
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
        Image image;
        image.size_px = glm::ivec2(n);
        for (std::size_t i = 0; i < plane; ++i)
            for (int channel = 0; channel < 4; ++channel)
                image.rgba.push_back(channel == 3 ? 255 : samples[k * plane + i]);
        write_image(image, folder + "/slice" + std::to_string(k) + ".png");
    }
}

// A window, and files of volume data.
struct VolumeRig : Rig {
    explicit VolumeRig(glm::ivec2 size = {1100, 900}) : Rig(size)
    {
        write_file(folder.file("ball.nrrd"), write_nrrd(ball_grid()));
        editor.preferences.timeline_open = false;
    }
    void drop(std::vector<std::string> paths)
    {
        screen.input().push(ui::drop_files(std::move(paths)));
        frames(2);
        wait();
    }
    // The ball with levels at these values, selected.
    void add_ball(const std::vector<double>& values)
    {
        AddVoxels add;
        add.shape.path = folder.file("ball.nrrd");
        for (const double value : values) add.shape.levels.push_back({.value = value});
        EXPECT_TRUE(editor.session.run(prepare(add, *editor.session.assets())));
        editor.session.selected = 1;
        editor.session.view.frame_all_when_evaluated = true;
        wait();
    }
    const VoxelShape& shape() const
    {
        return std::get<VoxelShape>(object(editor.session.committed(), 1).source);
    }
    TemporaryFolder folder;
};

} // namespace trivar::testing
