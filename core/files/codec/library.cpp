// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/codec/codec.h"

#include "core/files/codec/decode.h"
#include "core/files/color.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <exception>
#include <limits>
#include <memory>

namespace trivar {
namespace {

template <class Channel> std::string encoded(const EncodeTask& task, std::span<const Channel> rgba)
{
    constexpr auto type = sizeof(Channel) == 1 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
    constexpr auto full = static_cast<float>(std::numeric_limits<Channel>::max());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = "memory" + task.extension;
    const auto output = OIIO::ImageOutput::create(name);
    if (!output || !output->supports("ioproxy")) return {};
    output->set_ioproxy(&memory);
    OIIO::ImageSpec spec(task.size_px.x, task.size_px.y, output->supports("alpha") ? 4 : 3, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("CompressionQuality", 95);
    spec.attribute("DateTime", ""); // else some formats store the current time
    for (const auto& [tag, words] : task.tags) spec.attribute(tag, words);
    bool written = false;
    if (task.extension == ".exr" || task.extension == ".hdr") {
        spec.format = task.extension == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
        std::vector<float> linear(rgba.size());
        for (std::size_t i = 0; i < linear.size(); ++i) {
            const float value = rgba[i] / full;
            linear[i] = i % 4 == 3 ? value : linear_from_srgb(value);
        }
        written = output->open(name, spec) &&
                  output->write_image(OIIO::TypeDesc::FLOAT, linear.data(), 4 * sizeof(float));
    } else {
        written =
            output->open(name, spec) && output->write_image(type, rgba.data(), 4 * sizeof(Channel));
    }
    if (!written || !output->close()) {
        output->geterror();
        return {};
    }
    return {bytes.begin(), bytes.end()};
}

std::string encode_picture(const EncodeTask& task)
try {
    return task.deep.empty() ? encoded(task, task.rgba) : encoded(task, task.deep);
} catch (const std::exception&) {
    return {};
}

bool writes_pictures(const std::string& extension)
{
    const auto output = OIIO::ImageOutput::create("memory" + extension);
    return output && output->supports("ioproxy");
}

void keep_to_one_thread()
{
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1); // OpenEXR starts no threads of its own
}

} // namespace
} // namespace trivar

extern "C" const trivar::Codec trivar_codec{trivar::decode_picture, trivar::encode_picture,
                                            trivar::writes_pictures, trivar::keep_to_one_thread};
