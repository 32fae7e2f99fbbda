// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/sample_type.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <type_traits>

namespace trivar {
namespace {

constexpr std::size_t samples_per_block = std::size_t{1} << 18;

// Calls use(T()) for the C++ type of the samples.
template <class Use> auto with_type(SampleType type, const Use& use)
{
    if (type == SampleType::u8) return use(std::uint8_t());
    if (type == SampleType::i8) return use(std::int8_t());
    if (type == SampleType::u16) return use(std::uint16_t());
    if (type == SampleType::i16) return use(std::int16_t());
    if (type == SampleType::u32) return use(std::uint32_t());
    if (type == SampleType::i32) return use(std::int32_t());
    if (type == SampleType::u64) return use(std::uint64_t());
    if (type == SampleType::i64) return use(std::int64_t());
    if (type == SampleType::f32) return use(float());
    return use(double());
}

// The type in which a grid keeps samples of type T.
template <class T>
using Kept = std::conditional_t<std::is_integral_v<T> && sizeof(T) <= 2, T, float>;

template <class T> T loaded(const char* at, ByteOrder order)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    if (order == ByteOrder::big) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

// Doubles beyond the largest float become infinite, as IEEE 754 rounds them.
float as_float(double value)
{
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::abs(value) > largest && std::isfinite(value))
        return std::copysign(std::numeric_limits<float>::infinity(),
                             static_cast<float>(value > 0 ? 1 : -1));
    return static_cast<float>(value);
}

template <class T> bool is_rounded(T value, float kept)
{
    if constexpr (std::is_floating_point_v<T>)
        return !std::isnan(value) && static_cast<double>(kept) != static_cast<double>(value);
    else // a long double of x86 holds whole numbers of 64 bits
        return static_cast<long double>(kept) != static_cast<long double>(value);
}

template <class T> TakenSamples taken(std::string_view bytes, ByteOrder order)
{
    const std::size_t count = bytes.size() / sizeof(T);
    std::vector<Kept<T>> samples(count);
    std::vector<std::size_t> rounded(count / samples_per_block + 1, 0);
    parallel_blocks(count, samples_per_block, [&](std::size_t begin, std::size_t end) {
        if constexpr (std::is_same_v<T, Kept<T>>)
            if (order == ByteOrder::little || sizeof(T) == 1) {
                std::memcpy(samples.data() + begin, bytes.data() + begin * sizeof(T),
                            (end - begin) * sizeof(T));
                return;
            }
        for (std::size_t i = begin; i < end; ++i) {
            const T value = loaded<T>(bytes.data() + i * sizeof(T), order);
            if constexpr (std::is_same_v<T, Kept<T>>) {
                samples[i] = value;
            } else {
                if constexpr (std::is_same_v<T, double>)
                    samples[i] = as_float(value);
                else
                    samples[i] = static_cast<float>(value);
                rounded[begin / samples_per_block] += is_rounded(value, samples[i]);
            }
        }
    });
    return {std::move(samples), std::accumulate(rounded.begin(), rounded.end(), std::size_t{0})};
}

bool separates(char c)
{
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == ',' || c == '\v' || c == '\f';
}

template <class T> std::optional<T> number_of(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    return value;
}

template <class T>
TakenSamples taken_numbers(std::string_view text, const SampleBlock& block, const std::string& name)
{
    const std::size_t count = block.bytes() / size_of(block.type);
    if (count > text.size() / 2 + 1) // each number takes a digit and a blank
        throw Rejected(fmt::format("{} has {} bytes of text, too few for {} numbers", name,
                                   with_commas(text.size()), with_commas(count)));
    std::vector<Kept<T>> samples;
    samples.reserve(count);
    std::size_t rounded = 0, at = 0;
    while (true) {
        while (at < text.size() && separates(text[at])) ++at;
        if (at == text.size()) break;
        const std::size_t begin = at;
        while (at < text.size() && !separates(text[at])) ++at;
        const std::string_view word = text.substr(begin, at - begin);
        const std::optional<T> value = number_of<T>(word);
        if (!value)
            throw Rejected(fmt::format("{}: its sample {} is '{}'; it should be one of the {} that "
                                       "the head says",
                                       name, with_commas(samples.size()), shown(word),
                                       words_of(block.type)));
        if (samples.size() == count)
            throw Rejected(fmt::format("{} has more numbers than the {} of its {} x {} x {} voxels",
                                       name, with_commas(count), block.size[0], block.size[1],
                                       block.size[2]));
        if constexpr (std::is_same_v<T, double>)
            samples.push_back(as_float(*value));
        else
            samples.push_back(static_cast<Kept<T>>(*value));
        if constexpr (!std::is_same_v<T, Kept<T>>) rounded += is_rounded(*value, samples.back());
    }
    if (samples.size() != count)
        throw Rejected(fmt::format("{} has {} numbers; {} x {} x {} voxels need {}", name,
                                   with_commas(samples.size()), block.size[0], block.size[1],
                                   block.size[2], with_commas(count)));
    return {std::move(samples), rounded};
}

} // namespace

TakenSamples taken_samples(std::string_view bytes, SampleType type, ByteOrder order)
{
    return with_type(type, [&](auto example) { return taken<decltype(example)>(bytes, order); });
}

TakenSamples taken_words(std::string_view text, const SampleBlock& block, const std::string& name)
{
    return with_type(block.type, [&](auto example) {
        return taken_numbers<decltype(example)>(text, block, name);
    });
}

} // namespace trivar
