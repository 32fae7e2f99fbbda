// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_file.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/file_bytes.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/gltf/gltf_uri.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using GltfJson = nlohmann::json;

constexpr std::uintmax_t max_side_file_bytes = std::uintmax_t{2} << 30;

constexpr std::array<std::string_view, 5> supported_extensions{
    "KHR_mesh_quantization", "KHR_materials_emissive_strength", "KHR_texture_transform",
    "EXT_texture_webp", "EXT_mesh_gpu_instancing"};

// Returns the memory limit of a file: 256 MB, plus 32 bytes per byte of the file.
std::size_t memory_for(std::size_t file_bytes)
{
    return (std::size_t{1} << 28) + 32 * file_bytes;
}

GltfJson parsed_gltf(std::string_view text, const std::string& name)
{
    try {
        return GltfJson::parse(text);
    } catch (const GltfJson::parse_error& error) {
        const std::string_view before = text.substr(0, error.byte == 0 ? 0 : error.byte - 1);
        if (before.size() >= text.size())
            throw Rejected(name + ": its JSON is damaged or cut off: it ends in the middle");
        throw Rejected(fmt::format("{}: its JSON is damaged in line {}, near character {}", name,
                                   1 + std::ranges::count(before, '\n'),
                                   before.size() - (before.rfind('\n') + 1) + 1));
    } catch (const GltfJson::exception&) { // a number is out of range
        throw Rejected(name + ": its JSON has a number that is too large");
    }
}

void check_version(const GltfEntry& root)
{
    const std::optional<GltfEntry> asset = root.part("asset");
    const std::string_view version = asset ? asset->text("version") : "";
    if (version.empty())
        root.fail("it does not say that it is glTF 2: its 'asset' must have the 'version' \"2.0\"");
    if (version != "2" && !version.starts_with("2."))
        root.fail(fmt::format("this is glTF {}, but only glTF 2 can be read",
                              printable(version.substr(0, 20))));
}

std::vector<std::string> unsupported_extensions(const GltfEntry& root, const char* list)
{
    constexpr std::size_t longest = 60;
    std::vector<std::string> out;
    for (const std::string_view name : root.texts(list))
        if (std::ranges::find(supported_extensions, name) == supported_extensions.end())
            out.push_back(printable(name.substr(0, longest)));
    return out;
}

// Says whether a file can be read without an extension that it needs: it changes how surfaces look,
// or lights them, and no shape.
bool can_be_left_out(std::string_view extension)
{
    return extension.starts_with("KHR_materials_") || extension == "KHR_lights_punctual";
}

void check_extensions(const GltfEntry& root, CountedNotices& notices)
{
    for (const std::string& name : unsupported_extensions(root, "extensionsRequired"))
        if (!can_be_left_out(name))
            root.fail(fmt::format(
                "it needs the extension {}, which Trivar does not support; export it without",
                name));
    std::vector<std::string> used = unsupported_extensions(root, "extensionsUsed");
    constexpr std::size_t most_listed = 6;
    const std::size_t all = used.size();
    used.resize(std::min(all, most_listed));
    notices.add("its extension {1} is not supported and was left out",
                "{0} of its extensions are not supported and were left out: {1}", all,
                fmt::format("{}{}", fmt::join(used, ", "), all > most_listed ? " ..." : ""));
}

} // namespace

GltfFile::GltfFile(const FileText& file, bool binary, CountedNotices& notices)
    : file_(file),
      byte_count_(file.bytes.size())
{
    GlbViews parts{file.bytes, {}};
    try {
        if (binary)
            parts = glb_views(file.bytes);
        else if (file.bytes.starts_with("glTF"))
            throw Rejected("this is a GLB file: name it .glb");
        else if (nested_too_deep(file.bytes))
            throw Rejected("its JSON is nested too deep");
    } catch (const Rejected& why) {
        throw Rejected(fmt::format("{}: {}", file.name, why.what()));
    }
    // Some programs pad the chunk with zeros.
    const std::size_t end = parts.json.find_last_not_of('\0');
    json_ = std::make_unique<GltfJson>(parsed_gltf(parts.json.substr(0, end + 1), file.name));
    root_ = std::make_unique<GltfEntry>(*json_, file_.name);
    check_version(*root_);
    check_extensions(*root_, notices);
    const std::size_t count = root_->count("buffers");
    for (std::size_t i = 0; i < count; ++i)
        buffers_.push_back(
            opened(root_->item("buffers", "buffer", i), i == 0 ? parts.binary : std::nullopt));
    bytes_left_ = memory_for(byte_count_);
}

GltfFile::~GltfFile() = default;

void GltfFile::account(const GltfEntry& owner, std::size_t count, const char* called,
                       std::size_t bytes_each)
{
    if (count > bytes_left_ / bytes_each)
        owner.fail(fmt::format("it has {} {}; together with what was read before, that is more "
                               "than a file of {} bytes can hold",
                               with_commas(count), called, with_commas(byte_count_)));
    bytes_left_ -= count * bytes_each;
}

GltfFile::Buffer GltfFile::opened(const GltfEntry& buffer, std::optional<std::string_view> binary)
{
    const std::string_view uri = buffer.text("uri");
    if (uri.empty() && binary) return {*binary, {}};
    if (uri.empty())
        return {{},
                "it has no 'uri', and only the first buffer of a GLB file with a binary chunk "
                "goes without one"};
    auto known = by_uri_.find(uri);
    if (known == by_uri_.end()) {
        std::optional<std::string> bytes = uri_bytes(uri);
        if (!bytes)
            return {{},
                    is_data_uri(uri)
                        ? std::string("the text of its data uri is not base64")
                        : fmt::format("its file '{}' is not in the folder of the glTF file",
                                      excerpt(uri))};
        if (!is_data_uri(uri)) byte_count_ += bytes->size();
        known = by_uri_.emplace(uri, std::move(*bytes)).first;
    }
    return {known->second, {}};
}

std::optional<std::string> GltfFile::uri_bytes(std::string_view uri) const
{
    if (is_data_uri(uri)) return data_uri_bytes(uri);
    for (const std::string& name : {std::string(uri), without_escapes(uri)})
        if (const auto path = file_inside(file_.folder, name))
            return read_bytes(*path, max_side_file_bytes);
    return {};
}

GltfEntry GltfFile::named(const GltfEntry& owner, const char* name, const char* list,
                          const char* called) const
{
    const std::size_t index = owner.needed_index(name), count = root_->count(list);
    if (index >= count)
        owner.fail(fmt::format("'{}' names {} {}, which is not there: {}", name, called, index,
                               count == 0 ? "there is none"
                                          : fmt::format("the last is {} {}", called, count - 1)));
    return root_->item(list, called, index).as_named_by(owner, name);
}

std::string_view GltfFile::view(const GltfEntry& owner, const char* name) const
{
    const GltfEntry view = named(owner, name, "bufferViews", "bufferView"),
                    buffer = named(view, "buffer", "buffers", "buffer");
    const auto& [bytes, trouble] = buffers_[view.needed_index("buffer")];
    if (!trouble.empty()) buffer.fail(trouble);
    const std::size_t begin = view.size("byteOffset"), size = view.needed_size("byteLength");
    if (begin > bytes.size() || size > bytes.size() - begin)
        view.fail(fmt::format("it reaches to byte {} of buffer {}, which has {} bytes",
                              with_commas(begin + size), view.needed_index("buffer"),
                              with_commas(bytes.size())));
    return bytes.substr(begin, size);
}

} // namespace trivar
