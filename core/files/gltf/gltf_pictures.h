// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_file.h"
#include "core/files/pictures/image.h"

#include <map>

namespace trivar {

// GltfPictures decodes the pictures of a glTF file when they are asked for: each once, even if
// several images and textures share its bytes or its uri, and together no more than the file's size
// allows. A picture that cannot be read is null, with a notice.
class GltfPictures {
public:
    GltfPictures(const GltfFile& file, CountedNotices& notices);
    // `image` is below the length of the file's list.
    Ref<Image> picture(std::size_t image);

private:
    Ref<Image> read(const GltfEntry& image, std::size_t number);
    Ref<Image> decoded(std::string_view bytes, const std::string& name);

    const GltfFile& file_;
    CountedNotices& notices_;
    PictureReader pictures_;
    std::uintmax_t bytes_left_;
    std::map<std::size_t, Ref<Image>> by_image_;
    std::map<std::string_view, Ref<Image>> by_uri_;
    std::map<std::pair<const char*, std::size_t>, Ref<Image>> by_place_; // in a buffer
};

} // namespace trivar
