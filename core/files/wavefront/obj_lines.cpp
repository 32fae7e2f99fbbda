// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/wavefront/obj_lines.h"

namespace trivar {

ObjLines lines_of(std::vector<ObjBlock>& blocks, std::size_t v_count)
{
    ObjLines out;
    std::size_t v = 0;
    std::vector<std::uint32_t> line;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        ObjBlock& block = blocks[b];
        std::size_t at = 0;
        for (std::size_t l = 0; l < block.line_end.size(); ++l) {
            line.clear();
            bool whole = block.line_end[l] >= at + 2;
            for (; at < block.line_end[l]; ++at) {
                const std::int32_t vertex = absolute_index(block.line_vertices[at], v, v_count);
                whole = whole && vertex >= 0;
                line.push_back(static_cast<std::uint32_t>(vertex));
            }
            if (!whole) count_absent(out.left_out, b, l);
            if (!whole || !out.lines.add(line))
                block.lines_left_out.push_back(static_cast<std::uint32_t>(l));
        }
        v += block.counts.v;
        block.line_vertices = {};
    }
    return out;
}

} // namespace trivar
