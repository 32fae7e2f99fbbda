// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/usd_text.h"

#include "core/base/text.h"

#include <cctype>
#include <fmt/format.h>

namespace trivar {

std::string usd_number(float value)
{
    return shortest(value + 0.0f); // avoids -0
}

namespace {

template <class Vector> std::string tuple_text(const Vector& v)
{
    std::string out = "(";
    for (int i = 0; i < Vector::length(); ++i)
        out += (i > 0 ? ", " : "") + usd_number(static_cast<float>(v[i]));
    return out + ")";
}

template <class Vector> std::string list_text(const std::vector<Vector>& values)
{
    std::string out = "[";
    for (std::size_t i = 0; i < values.size(); ++i)
        out += (i > 0 ? ", " : "") + tuple_text(values[i]);
    return out + "]";
}

} // namespace

std::string usd_tuple(const glm::vec2& v)
{
    return tuple_text(v);
}

std::string usd_tuple(const glm::vec3& v)
{
    return tuple_text(v);
}

std::string usd_list(const std::vector<glm::vec2>& values)
{
    return list_text(values);
}

std::string usd_list(const std::vector<glm::vec3>& values)
{
    return list_text(values);
}

std::string usd_list(const std::vector<std::uint32_t>& values)
{
    std::string out = "[";
    for (std::size_t i = 0; i < values.size(); ++i)
        out += (i > 0 ? ", " : "") + std::to_string(values[i]);
    return out + "]";
}

std::string usd_matrix(const glm::dmat4& m) // rows in USD are columns here
{
    std::string out = "( ";
    for (int c = 0; c < 4; ++c) {
        out += c > 0 ? ", (" : "(";
        for (int r = 0; r < 4; ++r) out += (r > 0 ? ", " : "") + shortest(m[c][r] + 0.0);
        out += ")";
    }
    return out + " )";
}

std::string usd_name(const std::string& name, std::size_t number)
{
    std::string out;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        out += u < 128 && std::isalnum(u) ? c : '_';
    }
    if (out.empty() || std::isdigit(static_cast<unsigned char>(out.front()))) out = "_" + out;
    return fmt::format("{}_{}", out, number);
}

} // namespace trivar
