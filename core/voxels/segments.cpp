// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/segments.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"
#include "core/voxels/byte_stream.h"
#include "core/voxels/nrrd_fields.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

struct SegmentLines {
    std::string name;
    double value = 0, layer = 0;
};

// Takes a line "Segment0_Name:=bone".
void take_line(std::map<int, SegmentLines>& segments, std::string_view line)
{
    constexpr std::string_view begin = "Segment";
    if (!line.starts_with(begin)) return;
    const std::size_t under = line.find('_'), sign = line.find(":=");
    if (under == line.npos || sign == line.npos || under > sign) return;
    TextScan number(line.substr(begin.size(), under - begin.size()));
    const auto which = number.integer();
    if (!which || !number.done()) return;
    const std::string_view key = line.substr(under + 1, sign - under - 1);
    TextScan value(line.substr(sign + 2));
    if (key == "Name") segments[*which].name = shown(value.rest());
    if (key == "LabelValue") segments[*which].value = value.number().value_or(0);
    if (key == "Layer") segments[*which].layer = value.number().value_or(0);
}

} // namespace

std::vector<VolumeSegment> segments_of(const std::string& path)
{
    constexpr std::uint64_t most_head = 1'000'000;
    std::map<int, SegmentLines> lines;
    try {
        std::string buffer;
        const std::string_view head = ByteFile::opened(path).part(0, most_head, buffer);
        if (!head.starts_with("NRRD")) return {};
        const NrrdFields fields = nrrd_fields(head, path);
        for (TextScan scan(fields.text); !scan.done();) take_line(lines, scan.line());
    } catch (const Rejected&) { // said where it is read
        return {};
    }
    std::vector<VolumeSegment> out;
    for (const auto& [number, each] : lines)
        if (each.layer == 0 && each.value > 0) out.push_back({each.name, each.value, 0});
    std::ranges::sort(out, {}, &VolumeSegment::value);
    out.erase(std::unique(out.begin(), out.end(),
                          [](const auto& a, const auto& b) { return a.value == b.value; }),
              out.end());
    double below = 0;
    for (VolumeSegment& each : out) {
        each.level = (below + each.value) / 2;
        below = each.value;
    }
    return out;
}

} // namespace trivar
