// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/glb_chunks.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"

#include <cstdint>
#include <cstring>
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

GlbChunks glb_chunks(std::string_view bytes)
{
    if (bytes.size() < 20 || bytes.substr(0, 4) != "glTF") throw Rejected("this is no GLB file");
    const std::size_t length = glb_word(bytes, 12);
    if (length > bytes.size() - 20) throw Rejected("its JSON is cut off");
    const std::string_view text = bytes.substr(20, length);
    if (nested_too_deep(text)) throw Rejected("its JSON is nested too deep");
    GlbChunks out{std::string(text), {}};
    const std::size_t next = 20 + length;
    if (bytes.size() < next + 8) return out;
    const std::size_t size = glb_word(bytes, next);
    if (size > bytes.size() - next - 8) throw Rejected("its data is cut off");
    out.binary = bytes.substr(next + 8, size);
    return out;
}

std::string glb_container(const GlbChunks& chunks)
{
    const auto& [text, binary] = chunks;
    const std::size_t json_size = up_to_four(text.size()), data_size = up_to_four(binary.size());
    const std::size_t size = 20 + json_size + (binary.empty() ? 0 : 8 + data_size);
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw Rejected("a GLB file can have up to 4 GB, this model needs more");
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
