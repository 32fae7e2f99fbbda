// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/silhouette/device_silhouettes.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

constexpr std::size_t least_room = 1 << 14; // triangles
constexpr unsigned widest_dispatch = 65535; // groups along an axis, on every device

// The layout is that of crossed.comp.
struct CrossedRun {
    glm::vec4 least, greatest;
    glm::vec3 middle;
    std::uint32_t first, end;
    std::array<std::uint32_t, 3> unused{};
};
static_assert(sizeof(CrossedRun) == 64);

glm::vec4 as_vector(const std::array<float, 4>& v)
{
    return {v[0], v[1], v[2], v[3]};
}

std::vector<CrossedRun> runs_of(const LevelMesh& level)
{
    std::vector<CrossedRun> out;
    out.reserve(level.runs.size());
    for (const LevelMesh::Brick& brick : level.bricks) {
        std::uint32_t r = brick.first_run;
        for (std::uint32_t t = brick.first_triangle; t < brick.triangle_end;
             t += LevelMesh::run_length, ++r)
            out.push_back({.least = as_vector(level.runs[r].least),
                           .greatest = as_vector(level.runs[r].greatest),
                           .middle = brick.middle,
                           .first = t,
                           .end = std::min(t + LevelMesh::run_length, brick.triangle_end)});
    }
    return out;
}

ProgramName crossed_program()
{
    return {"", "", {}, "crossed"};
}

} // namespace

std::vector<ProgramName> DeviceSilhouettes::programs()
{
    return {crossed_program()};
}

bool DeviceSilhouettes::fits(const LevelMesh& level)
{
    GLint64 block = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    return std::max({level.positions.size() * sizeof(glm::vec4),
                     level.corners.size() * sizeof(std::uint32_t),
                     level.runs.size() * sizeof(CrossedRun)}) <= static_cast<std::size_t>(block);
}

void DeviceSilhouettes::take(const Ref<LevelMesh>& level)
{
    if (level == level_) return;
    std::vector<glm::vec4> normals(level->positions.size());
    for (std::size_t v = 0; v < normals.size(); ++v)
        normals[v] = {level->normal_x[v], level->normal_y[v], level->normal_z[v], level->offset(v)};
    const std::vector<std::uint32_t> corners = level->triangles();
    const std::vector<CrossedRun> runs = runs_of(*level);
    normals_.write(std::as_bytes(std::span(normals)));
    corners_.write(std::as_bytes(std::span<const std::uint32_t>(corners)));
    runs_.write(std::as_bytes(std::span(runs)));
    run_count_ = runs.size();
    level_ = level;
}

void DeviceSilhouettes::make_room(std::size_t triangles)
{
    room_ = std::max(room_, triangles);
    found_.reserve((room_ + 1) * sizeof(std::uint32_t));
}

const std::vector<std::uint32_t>& DeviceSilhouettes::crossed(Programs& programs,
                                                             const ViewPoint& view)
{
    triangles_.clear();
    if (run_count_ == 0) return triangles_;
    // The first request expects as many as the last time and a quarter more.
    std::size_t expected = std::max(least_room, last_count_ + last_count_ / 4);
    for (;;) {
        make_room(expected);
        const std::uint32_t none = 0;
        found_.write_part(0, std::as_bytes(std::span(&none, 1)));
        const std::array<const Buffer*, 4> buffers{&normals_, &corners_, &runs_, &found_};
        for (unsigned k = 0; k < buffers.size(); ++k)
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, k, buffers[k]->name());
        const Program& program = programs.use(crossed_program());
        program.set("view", glm::vec4(view.at));
        program.set("run_count", static_cast<unsigned>(run_count_));
        program.set("room", static_cast<unsigned>(room_));
        const auto runs = static_cast<unsigned>(run_count_);
        const unsigned wide = std::min(runs, widest_dispatch);
        glDispatchCompute(wide, (runs + wide - 1) / wide, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        triangles_.resize(expected + 1);
        found_.read(std::as_writable_bytes(std::span(triangles_)));
        const std::size_t count = triangles_[0];
        if (count <= expected) {
            triangles_.erase(triangles_.begin());
            triangles_.resize(count);
            std::ranges::sort(triangles_);
            last_count_ = count;
            return triangles_;
        }
        expected = count + count / 4;
    }
}

} // namespace trivar::gpu
