// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf_load.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <tiny_gltf.h>

namespace trivar {
namespace {

constexpr std::uintmax_t max_side_file_bytes = std::uintmax_t{2} << 30;

[[noreturn]] void fail(const FileText& file, const std::string& what)
{
    throw Rejected(fmt::format("{}: {}", file.name, what));
}

std::uint32_t word_at(std::string_view bytes, std::size_t offset)
{
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
}

// The JSON chunk of a GLB whose chunks lie inside it.
std::string_view json_chunk(const FileText& file)
{
    const std::string_view bytes = file.bytes;
    if (bytes.size() < 20 || bytes.substr(0, 4) != "glTF") fail(file, "this is no GLB file");
    if (word_at(bytes, 4) != 2)
        fail(file, fmt::format("this is glTF {}, only 2 can be read", word_at(bytes, 4)));
    const std::size_t length = word_at(bytes, 8), text = word_at(bytes, 12);
    if (length > bytes.size() || length < 20 || text > length - 20)
        fail(file, "the file is cut off");
    if (word_at(bytes, 16) != 0x4e4f534a) fail(file, "the first chunk of the file is no JSON");
    const std::size_t end = 20 + text;
    if (end < length && (length - end < 8 || word_at(bytes, end) > length - end - 8))
        fail(file, "the binary chunk is cut off");
    return bytes.substr(20, text);
}

void check_structure(const nlohmann::json& root, bool binary, const FileText& file)
{
    if (!root.is_object()) fail(file, "its JSON is damaged");
    const auto asset = root.find("asset");
    if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
        !(*asset)["version"].is_string() ||
        (*asset)["version"].get_ref<const std::string&>().substr(0, 1) != "2")
        fail(file, "it does not say that it is glTF 2");
    static const std::set<std::string> known{"KHR_mesh_quantization",
                                             "KHR_materials_emissive_strength"};
    if (const auto required = root.find("extensionsRequired");
        required != root.end() && required->is_array())
        for (const auto& name : *required)
            if (name.is_string() && !known.contains(name.get<std::string>()))
                fail(file, fmt::format("it needs the extension {}, which is not supported",
                                       name.get<std::string>()));
    const auto buffers = root.find("buffers");
    if (buffers == root.end() || !buffers->is_array()) return;
    // Each is copied when it is loaded: two that name one file or one chunk would double it.
    std::set<std::string> uris;
    for (const auto& buffer : *buffers) {
        if (!buffer.is_object()) fail(file, "a buffer is no JSON object");
        const auto uri = buffer.find("uri");
        const std::string name =
            uri != buffer.end() && uri->is_string() ? uri->get<std::string>() : std::string();
        if (name.empty() && !binary) fail(file, "a buffer has no uri");
        if (!uris.insert(name).second) fail(file, "two buffers share their bytes");
    }
}

bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*)
{
    // Those in buffer views are taken from there later, with their bounds checked.
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

bool exists_inside(const std::string& name, void* file)
{
    return file_inside(static_cast<const FileText*>(file)->folder, name).has_value();
}

bool read_inside(std::vector<unsigned char>* out, std::string* error, const std::string& name,
                 void* file)
{
    const auto path = file_inside(static_cast<const FileText*>(file)->folder, name);
    if (!path) {
        *error = "it is not in the folder";
        return false;
    }
    const std::string bytes = read_bytes(*path, max_side_file_bytes);
    out->assign(bytes.begin(), bytes.end());
    return true;
}

// One line, without the library's line ends and with the machine's folders left out of it.
std::string one_sentence(std::string text)
{
    while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.size() > 300 ? text.substr(0, 300) + " ..." : text;
}

} // namespace

LoadedGltf load_gltf(const FileText& file, bool binary)
{
    if (file.bytes.size() >= std::size_t{1} << 31) fail(file, "glTF files may have up to 2 GB");
    const std::string_view text = binary ? json_chunk(file) : file.bytes;
    if (nested_too_deep(text)) fail(file, "its JSON is nested too deep");
    try {
        check_structure(nlohmann::json::parse(text, nullptr, false), binary, file);
        LoadedGltf loaded{std::make_shared<tinygltf::Model>(), {}};
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(keep_encoded, nullptr);
        FileText source = file;
        loader.SetFsCallbacks({exists_inside, [](const std::string& path, void*) { return path; },
                               read_inside, nullptr, &source});
        std::string error, warning;
        const auto size = static_cast<unsigned>(file.bytes.size());
        const bool good = binary
                              ? loader.LoadBinaryFromMemory(
                                    loaded.gltf.get(), &error, &warning,
                                    reinterpret_cast<const unsigned char*>(file.bytes.data()), size)
                              : loader.LoadASCIIFromString(loaded.gltf.get(), &error, &warning,
                                                           file.bytes.data(), size, "");
        if (!good) fail(file, error.empty() ? "it is damaged" : one_sentence(error));
        if (!warning.empty())
            loaded.notices.push_back(fmt::format("{}: {}", file.name, one_sentence(warning)));
        return loaded;
    } catch (const Rejected&) {
        throw;
    } catch (const std::exception& thrown) {
        // tinygltf and the JSON library throw where a value has a type they did not expect.
        fail(file, fmt::format("it is damaged ({})", one_sentence(thrown.what())));
    }
}

} // namespace trivar
