// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/device_deformer.h"

#include "core/base/rejected.h"
#include "gpu/context.h"

#include <algorithm>
#include <bit>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace trivar::gpu {
namespace {

// volume_inputs.glsl
constexpr unsigned volume_binding = 1, points_binding = 0, cells_binding = 1;
constexpr unsigned points_unit = 14, cells_unit = 15;
constexpr unsigned group_size = 64; // vertex_buffers.glsl
// Slices begin where any device lets a buffer's range begin: a multiple of 256 bytes.
constexpr std::size_t slice_step = 256;

std::size_t bytes_in(const Buffer* buffer)
{
    return buffer ? buffer->bytes() : 0;
}

// The float whose bits bounds.comp.glsl ordered so.
double from_ordered(std::uint32_t ordered)
{
    return std::bit_cast<float>(ordered & 0x80000000u ? ordered ^ 0x80000000u : ~ordered);
}

template <class T> std::vector<T> values_in(const Buffer& buffer)
{
    std::vector<T> out(buffer.bytes() / sizeof(T));
    buffer.read(std::as_writable_bytes(std::span(out)));
    return out;
}

// A range of `count` vertices from `first` on, of so many bytes each.
void bind_range(unsigned binding, const Buffer& buffer, std::size_t first, std::size_t count,
                std::size_t bytes)
{
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer.name(),
                      static_cast<GLintptr>(first * bytes), static_cast<GLsizeiptr>(count * bytes));
}

} // namespace

VertexSource::VertexSource(const DeviceVertices& vertices)
    : positions(&vertices.positions),
      normals(&vertices.normals),
      tangents(&vertices.tangents),
      count(vertices.count),
      bounds(vertices.bounds)
{
}

DeviceVertices uploaded_vertices(const Mesh& mesh)
{
    DeviceVertices out;
    out.positions.write(std::as_bytes(std::span(mesh.positions)));
    out.normals.write(std::as_bytes(std::span(mesh.normals)));
    if (!mesh.normals.empty()) out.tangents.write(std::as_bytes(std::span(mesh.tangents)));
    out.count = mesh.vertex_count();
    out.bounds = bounding_box(mesh);
    return out;
}

DeformedArrays read_back(const DeviceVertices& vertices)
{
    return {values_in<glm::vec3>(vertices.positions), values_in<glm::vec3>(vertices.normals),
            values_in<glm::vec4>(vertices.tangents)};
}

DeviceLimits device_limits()
{
    DeviceLimits out;
    out.gl_version = epoxy_gl_version();
    if (out.gl_version < 43) return out;
    GLint64 block = 0;
    GLint groups = 0, texels = 0, in_vertex_shaders = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &in_vertex_shaders);
    out.texels = static_cast<std::size_t>(texels);
    out.reads_texels = is_software() || in_vertex_shaders < 2;
    out.storage_block = static_cast<std::size_t>(block);
    out.groups = static_cast<std::size_t>(groups);
    const std::size_t most =
        std::min(out.groups * group_size, out.storage_block / sizeof(glm::vec4));
    out.slice_vertices = most / slice_step * slice_step;
    return out;
}

Method method_of(DeformBy by)
{
    switch (by) {
    case DeformBy::differences: return {Sum::nested, NormalsBy::differences};
    case DeformBy::raised: return {Sum::raised, NormalsBy::differences};
    case DeformBy::filtered: return {Sum::filtered, NormalsBy::differences};
    default: return {};
    }
}

std::vector<std::string> volume_defines(const std::array<int, 3>& orders, bool texels)
{
    std::vector<std::string> out{fmt::format("ORDER_U {}", orders[0]),
                                 fmt::format("ORDER_V {}", orders[1]),
                                 fmt::format("ORDER_W {}", orders[2])};
    if (texels) out.emplace_back("TEXELS");
    return out;
}

ProgramName bounds_program(std::vector<std::string> volume_defines)
{
    return {"", "", std::move(volume_defines), "bounds"};
}

ProgramName deform_program(const DeformVariant& variant)
{
    const Method& method = variant.method;
    ProgramName name{"", "", volume_defines(variant.orders, variant.texels)};
    name.defines.push_back(fmt::format("NORMALS {}", static_cast<int>(method.normals)));
    if (variant.tangents && method.normals == NormalsBy::cofactors)
        name.defines.emplace_back("TANGENTS");
    if (method.sum != Sum::nested) name.defines.emplace_back("RAISED");
    if (method.sum == Sum::filtered) name.defines.emplace_back("FILTERED");
    name.compute = "deform";
    return name;
}

Box deformed_bounds(const Stage& stage, const Box& object)
{
    if (object.empty()) return {};
    Box rest, moved;
    for (const glm::dvec3& corner : object.corners())
        rest.add(glm::dvec3(stage.embedding.to_rest * glm::dvec4(corner, 1)));
    for (const glm::dvec3& d : stage.lattice->displacement.points) moved.add(d);
    return {rest.lo + moved.lo, rest.hi + moved.hi};
}

void dispatch_vertices(const Program& program, const VertexSource& from, const DeviceVertices& to,
                       const Attributes& attributes, const DeviceLimits& limits)
{
    for (std::size_t first = 0; first < from.count; first += limits.slice_vertices) {
        const std::size_t count = std::min(limits.slice_vertices, from.count - first);
        const auto both = [&](unsigned binding, const Buffer* in, const Buffer& out,
                              std::size_t size) {
            bind_range(binding, *in, first, count, size);
            bind_range(binding + 1, out, first, count, size);
        };
        both(2, from.positions, to.positions, sizeof(glm::vec3));
        if (attributes.normals) both(4, from.normals, to.normals, sizeof(glm::vec3));
        if (attributes.tangents) both(6, from.tangents, to.tangents, sizeof(glm::vec4));
        program.set("first_vertex", static_cast<unsigned>(first));
        program.set("vertex_count", static_cast<unsigned>(count));
        glDispatchCompute(static_cast<GLuint>((count + group_size - 1) / group_size), 1, 1);
    }
}

DeviceDeformer::DeviceDeformer(const DeviceLimits& limits) : limits_(limits)
{
    if (limits.gl_version < 43)
        throw Rejected(
            fmt::format("Deforming on the graphics card needs OpenGL 4.3, this is {}.{}.",
                        limits.gl_version / 10, limits.gl_version % 10));
    points_ = std::make_unique<Texels>();
    cells_ = std::make_unique<Texels>();
}

void DeviceDeformer::deform(const VertexSource& from, DeviceVertices& to,
                            std::span<const Stage> stages, const Method& method,
                            const glm::dvec3& origin_world)
{
    const auto reserve = [](Buffer& buffer, const Buffer* like, bool wanted) {
        if (wanted && bytes_in(like) > 0) buffer.reserve(bytes_in(like));
    };
    reserve(to.positions, from.positions, true);
    reserve(to.normals, from.normals, method.normals != NormalsBy::nothing);
    reserve(to.tangents, from.tangents, method.normals == NormalsBy::cofactors);
    to.count = from.count;
    to.bounds = from.bounds;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const bool last = i + 1 == stages.size();
        deform_by(stages[i], i == 0 ? from : VertexSource(to), to, method,
                  last ? origin_world : glm::dvec3(0));
        to.bounds = deformed_bounds(stages[i], to.bounds);
        if (!last) glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    to.bounds.lo -= origin_world;
    to.bounds.hi -= origin_world;
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void DeviceDeformer::bind(const Stage& stage, const Box& object, const glm::dvec3& origin_world)
{
    const DeviceLattice& lattice = lattices_.lattice(stage.lattice);
    const std::size_t largest = std::max(lattice.points.bytes(), lattice.axes->cells.bytes());
    const std::size_t most =
        limits_.reads_texels ? limits_.texels * sizeof(glm::vec4) : limits_.storage_block;
    if (largest > most)
        throw Rejected(fmt::format("The lattice takes {} kB; shaders of this graphics card see {}.",
                                   largest >> 10, most >> 10));
    const VolumeFrame frame =
        volume_frame(*stage.lattice, lattice.axes->packed, stage.embedding, object, origin_world);
    frame_.write(std::as_bytes(std::span(&frame, 1)));
    glBindBufferBase(GL_UNIFORM_BUFFER, volume_binding, frame_.name());
    if (limits_.reads_texels) {
        points_->bind(points_unit, lattice.points);
        cells_->bind(cells_unit, lattice.axes->cells);
        return;
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, points_binding, lattice.points.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, cells_binding, lattice.axes->cells.name());
}

void DeviceDeformer::deform_by(const Stage& stage, const VertexSource& from, DeviceVertices& to,
                               const Method& method, const glm::dvec3& origin_world)
{
    if (from.count == 0) return;
    bind(stage, to.bounds, origin_world);
    const PackedAxes& axes = lattices_.lattice(stage.lattice).axes->packed;
    if (method.sum != Sum::nested && !axes.raisable)
        throw Rejected("Order raising cannot evaluate a lattice that is torn at a knot.");
    if (method.sum == Sum::filtered) lattices_.texture(stage.lattice).bind(0);
    Method possible = method;
    if (bytes_in(from.normals) == 0) possible.normals = NormalsBy::nothing;
    const bool normals = possible.normals != NormalsBy::nothing,
               tangents = bytes_in(from.tangents) > 0 && possible.normals == NormalsBy::cofactors;
    const Program& program =
        programs_.use(deform_program({axes.order, possible, tangents, limits_.reads_texels}));
    dispatch_vertices(program, from, to, {normals, tangents}, limits_);
}

Box DeviceDeformer::box_of(const VertexSource& vertices, const Stage* by,
                           const glm::dvec3& origin_world)
{
    std::vector<std::string> defines;
    if (by) {
        bind(*by, vertices.bounds, origin_world);
        defines =
            volume_defines(lattices_.lattice(by->lattice).axes->packed.order, limits_.reads_texels);
    }
    const Program& program = programs_.use(bounds_program(std::move(defines)));
    constexpr std::uint32_t none = ~0u;
    std::array<std::uint32_t, 6> box{none, none, none, 0, 0, 0};
    bounds_.write(std::as_bytes(std::span(box)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, bounds_.name());
    for (std::size_t first = 0; first < vertices.count; first += limits_.slice_vertices) {
        const std::size_t count = std::min(limits_.slice_vertices, vertices.count - first);
        bind_range(2, *vertices.positions, first, count, sizeof(glm::vec3));
        program.set("vertex_count", static_cast<unsigned>(count));
        constexpr std::size_t most_groups = 128; // each ends with six atomic operations a thread
        glDispatchCompute(
            static_cast<GLuint>(std::min(most_groups, (count + group_size - 1) / group_size)), 1,
            1);
    }
    bounds_.read(std::as_writable_bytes(std::span(box)));
    Box out;
    for (int axis = 0; axis < 3; ++axis) {
        out.lo[axis] = from_ordered(box[static_cast<std::size_t>(axis)]);
        out.hi[axis] = from_ordered(box[static_cast<std::size_t>(axis) + 3]);
    }
    return vertices.count > 0 ? out : Box{};
}

} // namespace trivar::gpu
