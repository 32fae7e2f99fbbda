// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/plain/ply_values.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

template <class T> double decoded(const char* at, bool swap)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    if (swap) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
}

double decoded(PlyType type, const char* at, bool swap)
{
    switch (type) {
    case PlyType::i8: return decoded<std::int8_t>(at, swap);
    case PlyType::u8: return decoded<std::uint8_t>(at, swap);
    case PlyType::i16: return decoded<std::int16_t>(at, swap);
    case PlyType::u16: return decoded<std::uint16_t>(at, swap);
    case PlyType::i32: return decoded<std::int32_t>(at, swap);
    case PlyType::u32: return decoded<std::uint32_t>(at, swap);
    case PlyType::f32: return decoded<float>(at, swap);
    case PlyType::f64: break;
    }
    return decoded<double>(at, swap);
}

} // namespace

PlyValues::PlyValues(std::string_view data, PlyHeader::Format format, const std::string& name)
    : scan_(data),
      ascii_(format == PlyHeader::Format::ascii),
      swap_((format == PlyHeader::Format::little_endian) !=
            (std::endian::native == std::endian::little)),
      name_(name)
{
}

void PlyValues::begin(const PlyElement& element, std::size_t index)
{
    element_ = &element;
    index_ = index;
}

double PlyValues::value(PlyType type)
{
    if (ascii_) {
        while (!scan_.done() && (is_blank(*scan_.at) || *scan_.at == '\n')) ++scan_.at;
        last_ = scan_.at;
        if (scan_.done()) fail("the file ends here");
        const auto number = scan_.number();
        if (number && (scan_.done() || is_blank(*scan_.at) || *scan_.at == '\n')) return *number;
        scan_.word();
        return std::numeric_limits<double>::infinity();
    }
    const std::size_t size = size_of(type);
    if (left() < size) fail("the file ends here");
    last_value_ = decoded(type, scan_.at, swap_);
    scan_.at += size;
    return last_value_;
}

std::size_t PlyValues::list_length(const PlyProperty& property)
{
    const double length = value(property.count_type);
    const std::size_t least = ascii_ ? 2 : size_of(property.type);
    if (!(length >= 0) || length != std::floor(length) ||
        length * static_cast<double>(least) > static_cast<double>(left() + 1))
        fail(fmt::format("the length of a list is {}, which is more than the rest of the file "
                         "holds or not a whole number",
                         last()));
    return static_cast<std::size_t>(length);
}

void PlyValues::skip(const PlyProperty& property)
{
    const std::size_t count = property.list ? list_length(property) : 1;
    for (std::size_t i = 0; i < count; ++i) value(property.type);
}

// Throws Rejected if the file is too short: each value takes at least its size, or in text a
// character and a blank.
void PlyValues::check_count(const PlyElement& element) const
{
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
        least += ascii_ ? 2 : size_of(property.list ? property.count_type : property.type);
    if (least > 0 && element.count > (left() + 1) / least)
        throw Rejected(fmt::format("{}: {} of the element {} are declared, more than the {} bytes "
                                   "left can hold",
                                   name_, with_commas(element.count), shown(element.name),
                                   with_commas(left())));
}

std::string PlyValues::last() const
{
    return ascii_ ? shown(TextScan({last_, scan_.end}).word()) : fmt::format("{}", last_value_);
}

void PlyValues::fail(const std::string& what) const
{
    throw Rejected(fmt::format("{}: {} {} of {}, counted from 0: {}", name_, shown(element_->name),
                               index_, element_->count, what));
}

} // namespace trivar
