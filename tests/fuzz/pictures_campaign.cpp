// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/pictures_campaign.h"

#include "core/base/rejected.h"
#include "tests/fuzz/sound_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace trivar::testing {
namespace {

// Steele, Lea, Flood 2014: SplitMix64.
class Random {
public:
    Random(std::uint64_t seed, int number)
        : state_(seed * 0xd1342543de82ef95u + static_cast<std::uint64_t>(number))
    {
    }
    std::size_t below(std::size_t count)
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return (z ^ z >> 31) % count;
    }
    std::size_t place(const std::string& bytes)
    {
        return below(std::max<std::size_t>(1, bytes.size()));
    }

private:
    std::uint64_t state_;
};

constexpr std::array<std::size_t, 14> extremes{
    0, 1, 2, 3, 7, 0x7f, 0xff, 0x1000, 0x4000, 0x7fff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff};

// Numbers of the heads of kinds that have them at one place: where, and how many bytes.
struct Number {
    std::string_view extension;
    std::size_t at;
    int bytes;
    bool little;
};
constexpr std::array numbers{
    Number{"png", 16, 4, false}, Number{"png", 20, 4, false}, Number{"png", 24, 1, false},
    Number{"png", 25, 1, false}, Number{"png", 28, 1, false}, Number{"png", 8, 4, false},
    Number{"webp", 4, 4, true},  Number{"webp", 16, 4, true}, Number{"webp", 20, 4, true},
    Number{"webp", 24, 4, true}, Number{"webp", 26, 2, true}, Number{"webp", 28, 2, true},
    Number{"gif", 6, 2, true},   Number{"gif", 8, 2, true},   Number{"gif", 10, 1, true},
    Number{"bmp", 10, 4, true},  Number{"bmp", 14, 4, true},  Number{"bmp", 18, 4, true},
    Number{"bmp", 22, 4, true},  Number{"bmp", 28, 2, true},  Number{"bmp", 30, 4, true},
    Number{"bmp", 46, 4, true},  Number{"tga", 1, 1, true},   Number{"tga", 2, 1, true},
    Number{"tga", 3, 2, true},   Number{"tga", 5, 2, true},   Number{"tga", 7, 1, true},
    Number{"tga", 12, 2, true},  Number{"tga", 14, 2, true},  Number{"tga", 16, 1, true},
    Number{"tga", 17, 1, true},  Number{"dds", 8, 4, true},   Number{"dds", 12, 4, true},
    Number{"dds", 16, 4, true},  Number{"dds", 20, 4, true},  Number{"dds", 24, 4, true},
    Number{"dds", 28, 4, true},  Number{"dds", 76, 4, true},  Number{"dds", 80, 4, true},
    Number{"dds", 84, 4, true},  Number{"dds", 88, 4, true},  Number{"dds", 92, 4, true},
    Number{"dds", 96, 4, true},  Number{"dds", 100, 4, true}, Number{"dds", 104, 4, true},
    Number{"dds", 108, 4, true}, Number{"dds", 112, 4, true}, Number{"dds", 128, 4, true}};

void put(std::string& bytes, std::size_t at, const std::string& what)
{
    if (at < bytes.size()) bytes.replace(at, std::min(what.size(), bytes.size() - at), what);
}

std::string extreme(Random& random, int count, bool low_first)
{
    const std::size_t number = extremes[random.below(extremes.size())];
    return low_first ? little(number, count) : big(number, count);
}

std::size_t number_at(const std::string& bytes, std::size_t at, std::size_t count)
{
    std::size_t out = 0;
    for (std::size_t i = count; i-- > 0;)
        out = out << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    return out;
}

// Replaces the type, the count or the value of an entry in the directory of a TIFF.
void replace_entry(std::string& bytes, Random& random)
{
    const std::size_t directory = number_at(bytes, 4, 4), count = number_at(bytes, directory, 2);
    const std::size_t entry = directory + 2 + 12 * random.below(std::max<std::size_t>(1, count));
    const std::size_t part = random.below(4);
    put(bytes,
        entry + (part == 0   ? 2
                 : part == 1 ? 4
                             : 8),
        extreme(random, part == 0 ? 2 : 4, true));
}

// A number of the head, or one behind a name of the head's.
void replace_number(std::string& bytes, const std::string& extension, Random& random)
{
    if (extension == "tif" && random.below(4) != 0) return replace_entry(bytes, random);
    std::vector<Number> known;
    for (const Number& number : numbers)
        if (number.extension == extension) known.push_back(number);
    if (!known.empty() && random.below(4) != 0) {
        const Number& number = known[random.below(known.size())];
        return put(bytes, number.at, extreme(random, number.bytes, number.little));
    }
    static constexpr std::array<std::string_view, 10> names{
        "dataWindow", "displayWindow", "tiledesc", "chlist",   "compression",
        "\xff\xc0",   "\xff\xc2",      "\xff\xda", "\xff\xc4", "+X "};
    const std::string_view name = names[random.below(names.size())];
    const std::size_t found = bytes.find(name);
    if (found != std::string::npos && name == "+X ")
        return put(bytes, found + 3,
                   std::to_string(extremes[random.below(extremes.size())]) + "\n");
    const std::size_t near = found == std::string::npos ? 0 : found + name.size();
    const std::array<int, 3> counts{1, 2, 4};
    put(bytes, near + random.below(found == std::string::npos ? 200 : 30),
        extreme(random, counts[random.below(3)], random.below(2) == 0));
}

void change_some(std::string& bytes, Random& random)
{
    for (std::size_t left = 1 + random.below(8); left > 0; --left) {
        // Half of them where the head is, which decides most.
        const std::size_t at = random.below(2) == 0 ? random.below(64) : random.place(bytes);
        const auto to = static_cast<char>(random.below(256));
        put(bytes, at, std::string(1, to));
    }
}

void move_a_stretch(std::string& bytes, Random& random)
{
    const std::size_t at = random.place(bytes), count = 1 + random.below(64);
    if (at >= bytes.size()) return;
    const std::string stretch = bytes.substr(at, count);
    if (random.below(2) == 0)
        bytes.erase(at, count);
    else
        bytes.insert(random.place(bytes), stretch);
}

// Else a damaged PNG is refused for its checksum, and its decoder never sees it.
void make_checksums_right(std::string& bytes)
{
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - 12) return;
        put(bytes, at + 8 + length, big(png_checksum(bytes.substr(at + 4, 4 + length)), 4));
        at += 12 + length;
    }
}

} // namespace

PicturesCampaign::PicturesCampaign(const std::string& extension)
    : extension_(extension),
      sound_(sound_pictures(extension))
{
}

DamagedPicture PicturesCampaign::damaged(std::uint64_t seed, int number) const
{
    Random random(seed, number);
    std::string bytes = sound_[random.below(sound_.size())];
    for (std::size_t left = random.below(2) == 0 ? 1 : 1 + random.below(3); left > 0; --left)
        switch (random.below(9)) {
        case 0:
        case 1:
        case 2: change_some(bytes, random); break;
        case 3: bytes.resize(random.place(bytes)); break;
        case 4: move_a_stretch(bytes, random); break;
        case 5: bytes.insert(random.place(bytes), sound_[random.below(sound_.size())]); break;
        default: replace_number(bytes, extension_, random);
        }
    if (extension_ == "png" && random.below(4) != 0) make_checksums_right(bytes);
    return {"damaged." + extension_, bytes};
}

std::string use_picture(const DamagedPicture& picture, PictureReader& reader)
try {
    const Image image = reader.read_bytes(picture.bytes, picture.name);
    const glm::ivec2 size_px = picture_size(picture.bytes, picture.name);
    if (image.size_px != size_px || image.rgba.size() != 4 * static_cast<std::size_t>(size_px.x) *
                                                             static_cast<std::size_t>(size_px.y))
        throw std::logic_error("it has not as many pixels as it says");
    const GreyImage grey = reader.read_grey_bytes(picture.bytes, picture.name);
    if (grey.size_px != size_px || 4 * grey.values.size() != image.rgba.size())
        throw std::logic_error("it has not as many numbers as pixels");
    for (const float value : grey.values)
        if (!std::isfinite(value)) throw std::logic_error("a number of it is none");
    return {};
} catch (const Rejected& refused) {
    const std::string sentence = refused.what();
    if (!sentence.starts_with(picture.name + ": ") || sentence.find('\n') != sentence.npos)
        throw std::logic_error("no sentence that names the file: " + sentence);
    for (const char* word : {"libpng", "libtiff", "OpenEXR", "OpenImageIO", "ImageInput", "::"})
        if (sentence.find(word) != sentence.npos)
            throw std::logic_error("a library's words: " + sentence);
    return sentence;
}

} // namespace trivar::testing
