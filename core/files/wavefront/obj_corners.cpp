// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/wavefront/obj_corners.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {

std::int32_t absolute_index(std::int32_t index, std::size_t before, std::size_t count)
{
    if (index < 0) return index;
    const std::int64_t absolute =
        index < ObjCorner::limit ? index
                                 : static_cast<std::int64_t>(before) + index - ObjCorner::relative;
    if (absolute < 0 || absolute >= static_cast<std::int64_t>(count)) return ObjCorner::absent;
    return static_cast<std::int32_t>(absolute);
}

void count_absent(ObjAbsent& absent, std::size_t block, std::size_t face)
{
    if (absent.count++ == 0) absent.block = block, absent.face = face;
}

namespace {

template <class T> bool not_given(const std::vector<T>& values, std::int32_t index)
{
    return index >= 0 && std::isnan(values[static_cast<std::size_t>(index)].x);
}

} // namespace

ObjFaces faces_of(std::vector<ObjBlock>& blocks, std::size_t v_count,
                  const std::vector<glm::vec2>& vt, const std::vector<glm::vec3>& vn)
{
    ObjFaces faces;
    std::size_t corner_count = 0, face_count = 0;
    for (const ObjBlock& block : blocks) {
        corner_count += block.corners.size();
        face_count += block.face_end.size();
    }
    faces.corners.reserve(corner_count);
    faces.begin.reserve(face_count + 1);
    const bool some_bad =
        std::ranges::any_of(blocks, [](const auto& b) { return b.bad_lines > 0; });
    std::size_t v = 0, vt_before = 0, vn_before = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        ObjBlock& block = blocks[b];
        std::size_t c = 0;
        for (std::size_t f = 0; f < block.face_end.size(); ++f) {
            const std::size_t first = faces.corners.size();
            bool whole = true;
            for (; c < block.face_end[f]; ++c) {
                ObjCorner corner = block.corners[c];
                corner.v = absolute_index(corner.v, v, v_count);
                corner.vt = absolute_index(corner.vt, vt_before, vt.size());
                corner.vn = absolute_index(corner.vn, vn_before, vn.size());
                whole &= corner.v >= 0;
                if (corner.vt == ObjCorner::absent || corner.vn == ObjCorner::absent)
                    count_absent(faces.details, b, f);
                if (corner.vt < 0 || (some_bad && not_given(vt, corner.vt)))
                    corner.vt = ObjCorner::none;
                if (corner.vn < 0 || (some_bad && not_given(vn, corner.vn)))
                    corner.vn = ObjCorner::none;
                faces.corners.push_back(corner);
            }
            if (whole) {
                faces.begin.push_back(static_cast<std::uint32_t>(faces.corners.size()));
                continue;
            }
            faces.corners.resize(first);
            block.left_out.push_back(static_cast<std::uint32_t>(f));
            count_absent(faces.left_out, b, f);
        }
        v += block.counts.v;
        vt_before += block.counts.vt;
        vn_before += block.counts.vn;
        block.corners = {};
    }
    return faces;
}

ObjVertices unified(const std::vector<ObjCorner>& corners, std::size_t v_count)
{
    std::vector<std::uint32_t> begin(v_count + 1, 0);
    for (const ObjCorner& c : corners) ++begin[static_cast<std::size_t>(c.v) + 1];
    for (std::size_t v = 0; v < v_count; ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> at(corners.size());
    {
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::uint32_t c = 0; c < corners.size(); ++c)
            at[next[static_cast<std::size_t>(corners[c].v)]++] = c;
    }
    const auto key = [&](std::uint32_t c) { return std::pair(corners[c].vt, corners[c].vn); };
    parallel_blocks(v_count, 1 << 14, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v)
            std::sort(at.begin() + begin[v], at.begin() + begin[v + 1],
                      [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    });
    ObjVertices vertices;
    vertices.corners.resize(corners.size());
    vertices.first_of.resize(v_count + 1);
    for (std::size_t v = 0; v < v_count; ++v) {
        vertices.first_of[v] = static_cast<std::uint32_t>(vertices.of.size());
        for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
            if (i == begin[v] || key(at[i]) != key(at[i - 1]))
                vertices.of.push_back(corners[at[i]]);
            vertices.corners[at[i]] = static_cast<std::uint32_t>(vertices.of.size() - 1);
        }
    }
    vertices.first_of[v_count] = static_cast<std::uint32_t>(vertices.of.size());
    return vertices;
}

} // namespace trivar
