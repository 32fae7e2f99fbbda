// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_pictures.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_uri.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Returns the memory limit for all pictures of a file: half a gigabyte, which is 8 pictures of 4096
// x 4096 pixels, and more if the file has more than a byte per 16 pixels, as for photographs.
std::uintmax_t picture_bytes(std::uintmax_t file_bytes)
{
    return (std::uintmax_t{1} << 29) + 64 * file_bytes;
}

std::string picture_name(const GltfEntry& image, std::size_t number)
{
    const std::string_view name = image.text("name"), uri = image.text("uri");
    if (!name.empty()) return excerpt(name);
    if (!uri.empty() && !is_data_uri(uri)) return excerpt(uri);
    return fmt::format("picture {}", number);
}

} // namespace

GltfPictures::GltfPictures(const GltfFile& file, CountedNotices& notices)
    : file_(file),
      notices_(notices),
      bytes_left_(picture_bytes(file.byte_count()))
{
}

Ref<Image> GltfPictures::picture(std::size_t number)
{
    const auto [known, fresh] = by_image_.try_emplace(number);
    if (fresh) known->second = read(file_.root().item("images", "image", number), number);
    return known->second;
}

Ref<Image> GltfPictures::read(const GltfEntry& image, std::size_t number)
{
    const std::string name = picture_name(image, number);
    try {
        const std::string_view uri = image.text("uri");
        if (uri.empty()) {
            if (!image.has("bufferView")) image.fail("it has neither a 'uri' nor a 'bufferView'");
            const std::string_view bytes = file_.view(image, "bufferView");
            const auto [known, fresh] = by_place_.try_emplace({bytes.data(), bytes.size()});
            if (fresh) known->second = decoded(bytes, name);
            return known->second;
        }
        const auto [known, fresh] = by_uri_.try_emplace(uri);
        if (!fresh) return known->second;
        const std::optional<std::string> bytes = file_.uri_bytes(uri);
        if (!bytes && is_data_uri(uri)) throw Rejected(name + ": its data uri is not base64");
        if (bytes)
            known->second = decoded(*bytes, name);
        else
            notices_.add("the picture '{1}' is not in its folder",
                         "{0} pictures are not in its folder, '{1}' for one", 1, excerpt(uri));
        return known->second;
    } catch (const Rejected& why) {
        // The message may begin with the name of the file, which notices have anyway.
        std::string_view sentence = why.what();
        const std::string file = file_.name() + ": ";
        if (sentence.starts_with(file)) sentence.remove_prefix(file.size());
        notices_.add("{1}", "{0} of its pictures cannot be read, for one {1}", 1, sentence);
        return nullptr;
    }
}

Ref<Image> GltfPictures::decoded(std::string_view bytes, const std::string& name)
{
    const glm::dvec2 size_px(picture_size(bytes, name));
    const double needed = 4 * size_px.x * size_px.y + static_cast<double>(bytes.size());
    if (needed > static_cast<double>(bytes_left_)) {
        notices_.add("the picture '{1}' was left out: with the pictures before it, it has too many "
                     "pixels for the size of the file",
                     "{0} pictures were left out, '{1}' the first: with the pictures before them, "
                     "they have too many pixels for the size of the file",
                     1, name);
        return nullptr;
    }
    bytes_left_ -= static_cast<std::uintmax_t>(needed);
    return make_ref(pictures_.read_bytes(bytes, name));
}

} // namespace trivar
