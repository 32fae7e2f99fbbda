// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_sieve.h"

#include "gpu/tiles/late_counts.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

constexpr std::size_t tiles_per_group = 256; // tiles.comp.glsl
constexpr unsigned rule_binding = 2;
constexpr std::size_t number_bytes = sizeof(std::uint32_t);

ProgramName tiles_program(bool choose)
{
    return {"", "", choose ? std::vector<std::string>{"CHOOSE"} : std::vector<std::string>{},
            "tiles"};
}

void bind_storage(unsigned binding, const Buffer& buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
}

// Sets bytes of a buffer to 0, to its end.
void zero_from(const Buffer& buffer, std::size_t begin)
{
    if (begin >= buffer.bytes()) return;
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
    glClearBufferSubData(GL_COPY_WRITE_BUFFER, GL_R32UI, static_cast<GLintptr>(begin),
                         static_cast<GLsizeiptr>(buffer.bytes() - begin), GL_RED_INTEGER,
                         GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

// Resizes a buffer; its contents stay, and the rest is 0.
void resize_buffer(Buffer& buffer, std::size_t bytes)
{
    Buffer other;
    other.reserve(bytes);
    zero_from(other, 0);
    if (buffer.bytes() > 0) {
        glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
        glBindBuffer(GL_COPY_WRITE_BUFFER, other.name());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                            static_cast<GLsizeiptr>(std::min(bytes, buffer.bytes())));
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
        glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    }
    buffer = std::move(other);
}

} // namespace

std::vector<ProgramName> TileSieve::programs()
{
    return {tiles_program(true), tiles_program(false)};
}

bool TileSieve::fits(std::size_t tiles)
{
    GLint64 block = 0;
    GLint groups = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
    const std::size_t room = tiles + tiles / 2; // make_room()
    return room * std::max(sizeof(TileHull), TileRule::most_levels * number_bytes) <=
               static_cast<std::size_t>(block) &&
           tiles <= static_cast<std::size_t>(groups) * tiles_per_group;
}

void TileSieve::make_room(std::size_t count)
{
    const std::size_t room = count + count / 2; // for the next dabs of a brush
    hulls_.reserve(room * sizeof(TileHull));
    resize_buffer(levels_, room * number_bytes);
    sums_.reserve((room / tiles_per_group + 1) * LateCounts::kinds * number_bytes);
    rows_->capacity = room;
    rows_->rows.reserve(TileRule::most_levels * room * number_bytes);
}

void TileSieve::write(const TileSet& set, const glm::dvec3& origin)
{
    const Runs<TileSet::Extent> before = std::exchange(extents_, set.extents);
    bool all = std::exchange(origin_, origin) != origin;
    const std::size_t count = extents_.size();
    if (count > rows_->capacity || 4 * count < rows_->capacity) {
        make_room(count);
        all = true;
    }
    if (count < before.size()) zero_from(levels_, count * number_bytes);
    std::vector<TileHull> hulls;
    const auto upload_until = [&](std::size_t end) {
        if (hulls.empty()) return;
        hulls_.write_part((end - hulls.size()) * sizeof(TileHull), std::as_bytes(std::span(hulls)));
        hulls.clear();
    };
    for (std::size_t r = 0; r < extents_.runs().size(); ++r) {
        const std::size_t begin = extents_.begin_of(r);
        if (!all && begin < before.size()) {
            const std::size_t there = before.run_of(begin);
            if (before.begin_of(there) == begin && before.runs()[there] == extents_.runs()[r]) {
                upload_until(begin);
                continue;
            }
        }
        for (const TileSet::Extent& each : *extents_.runs()[r])
            hulls.push_back(hull_of(each, origin));
    }
    upload_until(count);
}

void TileSieve::forget_levels()
{
    zero_from(levels_, 0);
}

void TileSieve::take(std::vector<Command> commands)
{
    if (commands == commands_) return;
    commands_ = std::move(commands);
    rows_->commands.write(std::as_bytes(std::span(commands_)));
}

void TileSieve::choose(Programs& programs, const TileRule& rule, const DevicePyramid* before,
                       const Buffer& totals, std::size_t first_total)
{
    const std::size_t count = extents_.size();
    const auto groups = static_cast<unsigned>((count + tiles_per_group - 1) / tiles_per_group);
    rule_.write(std::as_bytes(std::span(&rule, 1)));
    glBindBufferBase(GL_UNIFORM_BUFFER, rule_binding, rule_.name());
    bind_storage(0, levels_);
    bind_storage(1, sums_);
    bind_storage(2, hulls_);
    bind_storage(3, before ? before->depths() : sums_); // without one nothing is read
    const Program& chooses = programs.use(tiles_program(true));
    chooses.set("tile_count", static_cast<unsigned>(count));
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    bind_storage(2, rows_->rows);
    bind_storage(3, rows_->commands);
    bind_storage(4, totals);
    const Program& lists = programs.use(tiles_program(false));
    lists.set("tile_count", static_cast<unsigned>(count));
    lists.set("capacity", static_cast<unsigned>(rows_->capacity));
    lists.set("command_count", static_cast<unsigned>(commands_.size()));
    lists.set("first_total", static_cast<unsigned>(first_total));
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace trivar::gpu
