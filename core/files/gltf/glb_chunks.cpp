// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_chunks.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"

#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

std::size_t glb_word(std::string_view bytes, std::size_t at)
{
    std::uint32_t out;
    std::memcpy(&out, bytes.data() + at, 4);
    return out;
}

void add_glb_word(std::string& bytes, std::size_t value)
{
    const auto word = static_cast<std::uint32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&word), 4);
}

std::size_t up_to_four(std::size_t size)
{
    return (size + 3) / 4 * 4;
}

} // namespace

GlbViews glb_views(std::string_view bytes)
{
    constexpr std::size_t head = 12, chunk_head = 8, json = 0x4e4f534a, binary = 0x004e4942;
    if (bytes.substr(0, 4) != "glTF")
        throw Rejected("this is not a GLB file: it does not begin with the letters glTF");
    if (bytes.size() < head + chunk_head) throw Rejected("the file is cut off in its first bytes");
    if (glb_word(bytes, 4) != 2)
        throw Rejected(
            fmt::format("this is glTF {}, but only glTF 2 can be read", glb_word(bytes, 4)));
    const std::size_t length = glb_word(bytes, 8);
    if (length > bytes.size() || length < head + chunk_head)
        throw Rejected(
            fmt::format("the file is cut off or damaged: it declares {} bytes but has {}",
                        with_commas(length), with_commas(bytes.size())));
    bytes = bytes.substr(0, length);
    GlbViews out;
    for (std::size_t at = head; bytes.size() - at >= chunk_head;) {
        const std::size_t size = glb_word(bytes, at), kind = glb_word(bytes, at + 4);
        const std::size_t left = bytes.size() - at - chunk_head;
        if (at == head && kind != json) throw Rejected("its first chunk is not its JSON");
        if (size > left)
            throw Rejected(fmt::format("{} is cut off: it declares {} bytes but has {}",
                                       at == head       ? "its JSON"
                                       : kind == binary ? "its binary chunk"
                                                        : "one of its chunks",
                                       with_commas(size), with_commas(left)));
        const std::string_view chunk = bytes.substr(at + chunk_head, size);
        if (at == head) out.json = chunk;
        if (kind == binary && !out.binary) out.binary = chunk;
        at += chunk_head + size;
    }
    if (nested_too_deep(out.json)) throw Rejected("its JSON is nested too deep");
    return out;
}

GlbChunks glb_chunks(std::string_view bytes)
{
    const GlbViews views = glb_views(bytes);
    return {std::string(views.json), std::string(views.binary.value_or(""))};
}

std::string glb_container(const GlbChunks& chunks)
{
    const auto& [text, binary] = chunks;
    const std::size_t json_size = up_to_four(text.size()), data_size = up_to_four(binary.size());
    const std::size_t size = 20 + json_size + (binary.empty() ? 0 : 8 + data_size);
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw Rejected("a GLB file holds at most 4 GB; this model needs more");
    std::string out;
    out.reserve(size);
    out += "glTF";
    for (const std::size_t word : {std::size_t{2}, size, json_size}) add_glb_word(out, word);
    out += "JSON" + text;
    out.append(json_size - text.size(), ' ');
    if (binary.empty()) return out;
    add_glb_word(out, data_size);
    out.append("BIN\0", 4).append(binary).append(data_size - binary.size(), '\0');
    return out;
}

} // namespace trivar
