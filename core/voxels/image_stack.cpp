// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/image_stack.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/files/pictures/image.h"
#include "core/voxels/volume_readers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

bool is_digit_of_name(char c)
{
    return c >= '0' && c <= '9';
}

// The digits of the last number in a name before its ending, without zeros in front.
std::string last_number(const std::string& name)
{
    const std::string stem = std::filesystem::path(name).stem().string();
    std::size_t end = stem.size();
    while (end > 0 && !is_digit_of_name(stem[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && is_digit_of_name(stem[begin - 1])) --begin;
    while (begin + 1 < end && stem[begin] == '0') ++begin;
    return stem.substr(begin, end - begin);
}

// Pictures one after another as the slices of a volume.
class Stack {
public:
    Stack(const glm::ivec2& size_px, int bits, std::string first_name)
        : size_(size_px),
          full_(bits > 8 ? 65535.0f : 255.0f),
          type_(bits == 8    ? SampleType::u8
                : bits == 16 ? SampleType::u16
                             : SampleType::f32),
          first_name_(std::move(first_name))
    {
    }

    SampleType type() const { return type_; }
    std::size_t not_numbers() const { return not_numbers_; }

    VoxelGrid::Samples slice(const GreyImage& image, const std::string& name)
    {
        if (image.size_px != size_)
            throw Rejected(fmt::format("{} has {} x {} pixels, but {} has {} x {}; all slices of a "
                                       "volume have one size",
                                       name, image.size_px.x, image.size_px.y, first_name_, size_.x,
                                       size_.y));
        not_numbers_ += image.no_numbers;
        VoxelGrid::Samples out = samples_for(type_, 0);
        std::visit(
            [&](auto& samples) {
                using T = std::ranges::range_value_t<decltype(samples)>;
                samples.reserve(image.values.size());
                for (const float value : image.values) samples.push_back(sample<T>(value, name));
            },
            out);
        return out;
    }

private:
    // The whole number that was stored, of its share of the largest one.
    template <class T> T sample(float value, const std::string& name) const
    {
        if constexpr (std::is_same_v<T, float>) {
            return value;
        } else {
            const float whole = std::round(value * full_);
            if (!(whole >= 0 && whole <= full_) || whole / full_ != value)
                throw Rejected(fmt::format("{} has colours or another depth than {}; the slices of "
                                           "a volume are grey and have one depth",
                                           name, first_name_));
            return static_cast<T>(whole);
        }
    }

    glm::ivec2 size_;
    float full_;
    SampleType type_;
    std::string first_name_;
    std::size_t not_numbers_ = 0;
};

void say_missing_numbers(const std::vector<std::string>& names, VoxelGrid& grid,
                         const std::string& folder)
{
    std::string before;
    for (const std::string& name : names) {
        const std::string number = last_number(name);
        constexpr std::size_t longest = 15;
        if (number.empty() || number.size() > longest) return;
        if (!before.empty() && std::stoll(number) != std::stoll(before) + 1) {
            grid.notices.push_back(fmt::format("{}: after number {} comes {}; no slice was put "
                                               "between them",
                                               folder, before, number));
            return;
        }
        before = number;
    }
}

} // namespace

std::vector<std::string> pictures_in_order(std::vector<std::string> names)
{
    const auto key = [](const std::string& name) {
        const std::string number = last_number(name);
        return std::tuple(number.size(), number, name);
    };
    std::ranges::sort(names, {}, key);
    return names;
}

bool may_be_slice(const std::string& name)
{
    constexpr const char* endings[] = {".png", ".tif", ".tiff", ".jpg", ".jpeg",
                                       ".bmp", ".exr", ".tga",  ".webp"};
    return std::ranges::find(endings, extension_of(name)) != std::end(endings);
}

ReadVolume read_image_stack(const std::string& folder, const std::vector<std::string>& names,
                            const ReadVolumeOptions& options, const Progress& progress)
{
    const std::filesystem::path root(folder);
    const std::string shown_folder = shown(root.filename().string());
    if (names.size() < 2)
        throw Rejected(
            fmt::format("{} has 1 picture; a volume has at least 2 slices", shown_folder));
    const std::vector<std::string> order = pictures_in_order(names);
    PictureReader reader;
    const ImageHead head = reader.head((root / order[0]).string(), {});
    Stack stack(head.size_px, head.bits, order[0]);
    const SampleBlock block{
        {head.size_px.x, head.size_px.y, static_cast<std::int64_t>(order.size())}, stack.type()};
    PartTaker taker(block, options, shown_folder);
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (!taker.wants(static_cast<std::int64_t>(k))) continue;
        report(progress, static_cast<double>(k) / static_cast<double>(order.size()), "Reading");
        taker.take_slice(stack.slice(reader.read_grey((root / order[k]).string()), order[k]));
    }
    ReadVolume out;
    out.part = taker.part();
    out.grid.size = out.part.size();
    out.grid.samples = taker.finish().samples;
    out.grid.to_metres = place_of(
        out.part, to_metres_of(upright_frame(options.spacing), metres_per_unit(options, 0)));
    if (stack.not_numbers() > 0)
        out.grid.notices.push_back(fmt::format("{}: {} of its pixels were no number and count as 0",
                                               shown_folder, with_commas(stack.not_numbers())));
    if (options.spacing == glm::dvec3(1))
        out.grid.notices.push_back(fmt::format("{}: pictures do not say how far their pixels and "
                                               "slices are apart; 1 was taken",
                                               shown_folder));
    say_missing_numbers(order, out.grid, shown_folder);
    out.companions = order;
    std::ranges::sort(out.companions);
    return out;
}

} // namespace trivar
