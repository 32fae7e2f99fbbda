// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_region.h"

#include "core/base/array_copies.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t gathered_per_block = 1 << 14, numbers_per_piece = 1 << 12;

// NumberSet is a set of numbers that says how many of its members are less than one.
class NumberSet {
public:
    explicit NumberSet(std::size_t end) : bits_(end / 64 + 1), before_(bits_.size()) {}
    void add(std::uint32_t i) { bits_[i / 64] |= std::uint64_t{1} << (i % 64); }
    std::vector<std::uint32_t> count() // before rank; returns the members, ascending
    {
        std::vector<std::uint32_t> out;
        for (std::size_t k = 0; k < bits_.size(); ++k) {
            before_[k] = static_cast<std::uint32_t>(out.size());
            for (std::uint64_t rest = bits_[k]; rest != 0; rest &= rest - 1)
                out.push_back(static_cast<std::uint32_t>(64 * k) +
                              static_cast<std::uint32_t>(std::countr_zero(rest)));
        }
        return out;
    }
    std::uint32_t rank(std::uint32_t i) const // of a member
    {
        const std::uint64_t less = bits_[i / 64] & ((std::uint64_t{1} << (i % 64)) - 1);
        return before_[i / 64] + static_cast<std::uint32_t>(std::popcount(less));
    }

private:
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint32_t> before_;
};

// An array that would double its memory for a few elements more takes room for them alone.
template <class Value> void make_room(std::vector<Value>& array, std::size_t more)
{
    if (array.capacity() < array.size() + more) array.reserve(array.size() + 2 * more);
}

template <class Value>
std::vector<Value> gathered(const std::vector<Value>& from, const std::vector<std::uint32_t>& which)
{
    if (from.empty()) return {};
    std::vector<Value> out(which.size());
    parallel_blocks(which.size(), gathered_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = from[which[i]];
    });
    return out;
}

// Puts the region's values into its vertices, and those of new vertices after all others.
template <class Value>
void replace_values(std::vector<Value>& out, const std::vector<Value>& changed,
                    const std::vector<std::uint32_t>& vertices)
{
    if (changed.empty()) return;
    for (std::size_t i = 0; i < vertices.size(); ++i) out[vertices[i]] = changed[i];
    make_room(out, changed.size() - vertices.size());
    out.insert(out.end(), changed.begin() + static_cast<long>(vertices.size()), changed.end());
}

// Values of faces, that are all 0 where there is no array.
void append_values(std::vector<std::uint32_t>& out, const std::vector<std::uint32_t>& more,
                   std::size_t faces)
{
    if (out.empty() && more.empty()) return;
    out.resize(faces, 0);
    if (more.empty()) return;
    make_room(out, more.size());
    out.insert(out.end(), more.begin(), more.end());
}

// Appends value(i) for every i < count: in pieces, as resizing clears what is then written.
void append_numbers(std::vector<std::uint32_t>& out, std::size_t count, const auto& value)
{
    for (std::size_t begin = 0; begin < count; begin += numbers_per_piece) {
        const std::size_t end = std::min(count, begin + numbers_per_piece), at = out.size();
        out.resize(at + end - begin);
        for (std::size_t i = begin; i < end; ++i) out[at + i - begin] = value(i);
    }
}

// A point for every vertex, with room for more.
void copy_points(const Mesh& mesh, std::size_t more, std::vector<std::uint32_t>& out)
{
    if (!mesh.points.empty()) return copy_with_room(mesh.points, more, out);
    empty_with_room(out, mesh.vertex_count() + more, more);
    append_numbers(out, mesh.vertex_count(),
                   [](std::size_t v) { return static_cast<std::uint32_t>(v); });
}

// Makes the faces of `out` those of a mesh but for some (ascending), in their order, with room for
// more faces and corners.
void take_other_faces(Mesh& out, const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                      std::size_t more_faces, std::size_t more_corners)
{
    // Calls with the faces from `begin` to before `end` that stay
    const auto for_runs = [&](const auto& body) {
        std::size_t begin = 0;
        for (std::size_t k = 0; k <= left_out.size(); ++k) {
            const std::size_t end = k < left_out.size() ? left_out[k] : mesh.face_count();
            if (begin < end) body(begin, end);
            begin = end + 1;
        }
    };
    ArrayCopies copies;
    copies.add([&] {
        empty_with_room(out.corners, mesh.corners.size() + more_corners, more_corners);
        for_runs([&](std::size_t begin, std::size_t end) {
            out.corners.insert(out.corners.end(), mesh.corners.begin() + mesh.face_begin[begin],
                               mesh.corners.begin() + mesh.face_begin[end]);
        });
    });
    copies.add([&] {
        empty_with_room(out.face_begin, mesh.face_begin.size() + more_faces, more_faces);
        out.face_begin.push_back(0);
        for_runs([&](std::size_t begin, std::size_t end) {
            const std::uint32_t shift = out.face_begin.back() - mesh.face_begin[begin];
            append_numbers(out.face_begin, end - begin,
                           [&](std::size_t f) { return mesh.face_begin[begin + f + 1] + shift; });
        });
    });
    for (const auto member : {&Mesh::face_material, &Mesh::face_group})
        copies.add([&, member] {
            const std::vector<std::uint32_t>& from = mesh.*member;
            std::vector<std::uint32_t>& to = out.*member;
            to.clear();
            if (from.empty()) return;
            empty_with_room(to, from.size() + more_faces, more_faces);
            for_runs([&](std::size_t begin, std::size_t end) {
                to.insert(to.end(), from.begin() + static_cast<long>(begin),
                          from.begin() + static_cast<long>(end));
            });
        });
    copies.run();
}

} // namespace

MeshRegion region_of(const Mesh& whole, std::size_t points, std::vector<std::uint32_t> faces)
{
    MeshRegion out;
    out.whole_points = points;
    out.faces = std::move(faces);
    NumberSet vertices(whole.vertex_count());
    std::size_t corners = 0;
    for (const std::uint32_t f : out.faces) {
        for (std::uint32_t c = whole.face_begin[f]; c < whole.face_begin[f + 1]; ++c)
            vertices.add(whole.corners[c]);
        corners += whole.face_begin[f + 1] - whole.face_begin[f];
    }
    out.vertices = vertices.count();
    Mesh& mesh = out.mesh;
    mesh.corners.reserve(corners);
    mesh.face_begin.reserve(out.faces.size() + 1);
    for (const std::uint32_t f : out.faces) {
        for (std::uint32_t c = whole.face_begin[f]; c < whole.face_begin[f + 1]; ++c)
            mesh.corners.push_back(vertices.rank(whole.corners[c]));
        mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    mesh.face_material = gathered(whole.face_material, out.faces);
    mesh.face_group = gathered(whole.face_group, out.faces);
    mesh.positions = gathered(whole.positions, out.vertices);
    mesh.normals = gathered(whole.normals, out.vertices);
    mesh.tangents = gathered(whole.tangents, out.vertices);
    mesh.colors = gathered(whole.colors, out.vertices);
    for (const auto& set : whole.uvs) mesh.uvs.push_back(gathered(set, out.vertices));
    mesh.influences = gathered(whole.influences, out.vertices);
    for (const Mesh::MorphTarget& target : whole.morph_targets)
        mesh.morph_targets.push_back({gathered(target.positions, out.vertices),
                                      gathered(target.normals, out.vertices),
                                      gathered(target.tangents, out.vertices)});
    if (whole.points.empty()) {
        out.points = out.vertices;
        mesh.points.resize(out.vertices.size());
        std::iota(mesh.points.begin(), mesh.points.end(), 0u);
        return out;
    }
    NumberSet known(points);
    for (const std::uint32_t v : out.vertices) known.add(whole.points[v]);
    out.points = known.count();
    mesh.points.reserve(out.vertices.size());
    for (const std::uint32_t v : out.vertices) mesh.points.push_back(known.rank(whole.points[v]));
    return out;
}

void put_back(Mesh& out, const MeshRegion& region, const Mesh& changed)
{
    const std::size_t vertices = out.vertex_count(), kept = region.vertices.size();
    const std::size_t faces = out.face_count();
    ArrayCopies copies;
    const auto replaced = [&](auto& values, const auto& by) {
        copies.add([&] { replace_values(values, by, region.vertices); });
    };
    copies.add([&] {
        std::vector<std::uint32_t> number(changed.vertex_count());
        std::ranges::copy(region.vertices, number.begin());
        std::iota(number.begin() + static_cast<long>(kept), number.end(),
                  static_cast<std::uint32_t>(vertices));
        make_room(out.corners, changed.corners.size());
        for (const std::uint32_t corner : changed.corners) out.corners.push_back(number[corner]);
    });
    copies.add([&] {
        make_room(out.face_begin, changed.face_count());
        const std::uint32_t first = out.face_begin.back();
        for (std::size_t f = 1; f < changed.face_begin.size(); ++f)
            out.face_begin.push_back(first + changed.face_begin[f]);
        append_values(out.face_material, changed.face_material, faces);
        append_values(out.face_group, changed.face_group, faces);
    });
    replaced(out.positions, changed.positions);
    replaced(out.normals, changed.normals);
    replaced(out.tangents, changed.tangents);
    replaced(out.colors, changed.colors);
    replaced(out.influences, changed.influences);
    for (std::size_t set = 0; set < out.uvs.size(); ++set) replaced(out.uvs[set], changed.uvs[set]);
    for (std::size_t i = 0; i < out.morph_targets.size(); ++i)
        for (const auto member : {&Mesh::MorphTarget::positions, &Mesh::MorphTarget::normals,
                                  &Mesh::MorphTarget::tangents})
            replaced(out.morph_targets[i].*member, changed.morph_targets[i].*member);
    copies.add([&] {
        make_room(out.points, changed.vertex_count() - kept);
        const auto first = static_cast<std::uint32_t>(region.whole_points);
        const auto known = static_cast<std::uint32_t>(region.points.size());
        for (std::size_t v = kept; v < changed.vertex_count(); ++v) {
            const std::uint32_t p = changed.points[v];
            out.points.push_back(p < known ? region.points[p] : first + (p - known));
        }
    });
    copies.run();
}

void copy_others(Mesh& out, const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                 std::size_t more_vertices, std::size_t more_triangles)
{
    ArrayCopies copies;
    const auto copied = [&](const auto& from, auto& to) {
        copies.add([&from, &to, more_vertices] {
            copy_with_room(from, from.empty() ? 0 : more_vertices, to);
        });
    };
    copies.add([&] { take_other_faces(out, mesh, left_out, more_triangles, 3 * more_triangles); });
    copies.add([&] { copy_points(mesh, more_vertices, out.points); });
    copied(mesh.positions, out.positions);
    copied(mesh.normals, out.normals);
    copied(mesh.tangents, out.tangents);
    copied(mesh.colors, out.colors);
    copied(mesh.influences, out.influences);
    out.uvs.resize(mesh.uvs.size());
    for (std::size_t set = 0; set < mesh.uvs.size(); ++set) copied(mesh.uvs[set], out.uvs[set]);
    out.morph_targets.resize(mesh.morph_targets.size());
    for (std::size_t i = 0; i < mesh.morph_targets.size(); ++i)
        for (const auto member : {&Mesh::MorphTarget::positions, &Mesh::MorphTarget::normals,
                                  &Mesh::MorphTarget::tangents})
            copied(mesh.morph_targets[i].*member, out.morph_targets[i].*member);
    copies.run();
    out.group_names = mesh.group_names;
    out.creases = mesh.creases;
}

} // namespace trivar
