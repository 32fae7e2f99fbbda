// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/raw_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string_view>

namespace trivar {
namespace {

constexpr std::size_t most_guesses = 12;

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

// A NameNumber is a whole number in a name, with the text between it and the one before.
struct NameNumber {
    std::int64_t value = 0;
    std::string before;
};

std::vector<NameNumber> numbers_in(std::string_view name)
{
    std::vector<NameNumber> numbers;
    std::string between;
    for (std::size_t at = 0; at < name.size();) {
        if (!is_digit(name[at])) {
            between += name[at++];
            continue;
        }
        NameNumber number{0, between};
        std::size_t digits = 0;
        for (; at < name.size() && is_digit(name[at]); ++at, ++digits)
            if (digits < 9) number.value = 10 * number.value + (name[at] - '0');
        if (digits > 9) number.value = 0;
        numbers.push_back(number);
        between.clear();
    }
    return numbers;
}

// Three numbers with the same mark between them: 256x256x128, or 256_256_128.
std::optional<std::array<std::int64_t, 3>> sizes_in(std::string_view name)
{
    const std::vector<NameNumber> numbers = numbers_in(name);
    for (const std::string_view mark : {"x", "\xc3\x97", "_", "-", " "})
        for (std::size_t k = 0; k + 2 < numbers.size(); ++k)
            if (numbers[k + 1].before == mark && numbers[k + 2].before == mark &&
                numbers[k].value > 1 && numbers[k + 1].value > 1 && numbers[k + 2].value > 1)
                return std::array{numbers[k].value, numbers[k + 1].value, numbers[k + 2].value};
    return {};
}

std::vector<std::string> words_in(std::string_view name)
{
    std::vector<std::string> words(1);
    for (const char c : name)
        if (is_digit(c) || (c >= 'a' && c <= 'z'))
            words.back() += c;
        else
            words.emplace_back();
    return words;
}

std::optional<SampleType> type_in(std::string_view name)
{
    struct Word {
        std::string_view word;
        SampleType type;
    };
    constexpr Word known[] = {
        {"u8", SampleType::u8},       {"uint8", SampleType::u8},    {"uchar", SampleType::u8},
        {"byte", SampleType::u8},     {"8bit", SampleType::u8},     {"i8", SampleType::i8},
        {"s8", SampleType::i8},       {"int8", SampleType::i8},     {"u16", SampleType::u16},
        {"uint16", SampleType::u16},  {"ushort", SampleType::u16},  {"16bit", SampleType::u16},
        {"i16", SampleType::i16},     {"s16", SampleType::i16},     {"int16", SampleType::i16},
        {"short", SampleType::i16},   {"u32", SampleType::u32},     {"uint32", SampleType::u32},
        {"i32", SampleType::i32},     {"int32", SampleType::i32},   {"f32", SampleType::f32},
        {"float", SampleType::f32},   {"float32", SampleType::f32}, {"f64", SampleType::f64},
        {"float64", SampleType::f64}, {"double", SampleType::f64}};
    for (const std::string& word : words_in(name))
        for (const Word& each : known)
            if (word == each.word) return each.type;
    return {};
}

ByteOrder order_in(std::string_view name)
{
    for (const std::string& word : words_in(name))
        if (word == "be" || word == "msb" || word == "big" || word == "bigendian")
            return ByteOrder::big;
    return ByteOrder::little;
}

// Sizes for a number of voxels: a cube, then stacks of square slices, the nearest to a cube first.
std::vector<std::array<std::int64_t, 3>> usual_sizes(std::uint64_t voxels)
{
    std::vector<std::array<std::int64_t, 3>> sizes;
    const auto total = static_cast<std::int64_t>(voxels);
    const auto side =
        static_cast<std::int64_t>(std::llround(std::cbrt(static_cast<double>(total))));
    if (side > 1 && side * side * side == total) sizes.push_back({side, side, side});
    for (const std::int64_t wide : {2048, 1024, 768, 512, 384, 320, 256, 192, 128, 64, 32}) {
        const std::int64_t slices = total / (wide * wide);
        if (wide != side && slices > 1 && slices * wide * wide == total && slices >= wide / 16 &&
            slices <= 8 * wide)
            sizes.push_back({wide, wide, slices});
    }
    const auto squeeze = [](const std::array<std::int64_t, 3>& size) {
        return std::abs(std::log2(static_cast<double>(size[2]) / static_cast<double>(size[0])));
    };
    std::ranges::stable_sort(sizes, {}, squeeze);
    return sizes;
}

} // namespace

std::vector<RawGuess> raw_guesses(const std::string& name, std::uint64_t bytes)
{
    std::string stem = std::filesystem::path(name).stem().string();
    for (char& c : stem)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto sizes = sizes_in(stem);
    std::vector<SampleType> types{SampleType::u8,  SampleType::u16, SampleType::i16,
                                  SampleType::f32, SampleType::f64, SampleType::u32};
    if (const auto type = type_in(stem)) types = {*type};
    const ByteOrder order = order_in(stem);
    std::vector<RawGuess> named, usual;
    for (const SampleType type : types) {
        if (bytes % size_of(type) != 0 || bytes > std::uint64_t{1} << 62) continue;
        const std::uint64_t voxels = bytes / size_of(type);
        if (sizes) {
            const auto [x, y, z] = *sizes; // below 1e9 each
            const std::uint64_t slice =
                static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y);
            if (voxels % slice == 0 && voxels / slice == static_cast<std::uint64_t>(z))
                named.push_back({{{*sizes, type}, order}, true});
        }
        for (const auto& size : usual_sizes(voxels))
            usual.push_back({{{size, type}, order}, false});
    }
    named.insert(named.end(), usual.begin(), usual.end());
    if (named.size() > most_guesses) named.resize(most_guesses);
    return named;
}

std::string words_of(const RawLayout& layout)
{
    const auto& size = layout.block.size;
    return fmt::format("{} x {} x {} {}", size[0], size[1], size[2], words_of(layout.block.type));
}

} // namespace trivar
