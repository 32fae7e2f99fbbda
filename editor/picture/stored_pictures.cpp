// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/stored_pictures.h"

#include "core/files/pictures/image.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar {

Image shrunk(const Image& image, int width_px)
{
    const int by = std::max(1, image.size_px.x / std::max(1, width_px));
    if (by == 1) return image;
    Image small;
    small.size_px = image.size_px / by;
    small.rgba.reserve(static_cast<std::size_t>(small.size_px.x) * small.size_px.y * 4);
    const auto wide = static_cast<std::size_t>(image.size_px.x);
    for (int y = 0; y < small.size_px.y; ++y)
        for (int x = 0; x < small.size_px.x; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                int sum = 0;
                for (int j = 0; j < by; ++j)
                    for (int i = 0; i < by; ++i) {
                        const auto row = static_cast<std::size_t>(y * by + j);
                        const auto column = static_cast<std::size_t>(x * by + i);
                        sum += image.rgba[(row * wide + column) * 4 + channel];
                    }
                small.rgba.push_back(static_cast<std::uint8_t>(sum / (by * by)));
            }
    return small;
}

const gpu::Texture2D* StoredPictures::of(const std::string& path, int width_px)
{
    const auto [entry, fresh] = pictures_.try_emplace({path, width_px});
    if (fresh)
        jobs_.start({"Reading " + path,
                     [this, path, width_px](const Progress&) -> Jobs::Finish {
                         auto image =
                             std::make_shared<const Image>(shrunk(read_image(path), width_px));
                         return [this, path, width_px, image] {
                             gpu::Texture2D texture(GL_RGBA8, image->size_px, true);
                             texture.write_rgba(image->rgba);
                             pictures_[{path, width_px}] = std::move(texture);
                         };
                     },
                     [](const std::string&) {}});
    return entry->second ? &*entry->second : nullptr;
}

const gpu::Texture2D& StoredPictures::given(const std::string& name, long version,
                                            const Image& image)
{
    const auto found = given_.find(name);
    if (found != given_.end() && found->second.first == version) return found->second.second;
    gpu::Texture2D texture(GL_RGBA8, image.size_px, true);
    texture.write_rgba(image.rgba);
    return given_.insert_or_assign(name, std::pair(version, std::move(texture)))
        .first->second.second;
}

double StoredPictures::shape(const std::string& path, int width_px)
{
    const gpu::Texture2D* texture = of(path, width_px);
    if (!texture) return 16.0 / 9;
    return static_cast<double>(texture->size_px().x) / texture->size_px().y;
}

} // namespace trivar
