// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/color.h"
#include "core/files/formats.h"
#include "core/files/ply_header.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <optional>

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

class PlyReader {
public:
    PlyReader(const FileText& file, const Progress& progress)
        : file_(file),
          progress_(progress),
          header_(read_ply_header(file.bytes, file.name)),
          scan_(file.bytes.substr(header_.size)),
          ascii_(header_.format == PlyHeader::Format::ascii),
          swap_((header_.format == PlyHeader::Format::little_endian) !=
                (std::endian::native == std::endian::little))
    {
    }

    Model read()
    {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue;
            check_count(element);
            if ((element.name == "vertex" && mesh_.vertex_count() > 0) ||
                (element.name == "face" && mesh_.face_count() > 0))
                fail(fmt::format("the element {} comes twice", element.name));
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else if (element.name == "tristrips")
                fail("triangle strips cannot be read, save it with faces");
            else
                skip(element);
        }
        for (const std::uint32_t v : mesh_.corners)
            if (v >= mesh_.vertex_count())
                fail(fmt::format("a face asks for vertex {}, there are {}", v,
                                 mesh_.vertex_count()));
        // The format has no other way to say a seam than two vertices at one place.
        mesh_.points = points_by_position(mesh_.positions);
        Model model = single_mesh_model("", std::move(mesh_));
        if (repaired_values_ > 0)
            model.notices.push_back(
                fmt::format("{}: {} normals, colours or texture coordinates were no finite numbers",
                            file_.name, repaired_values_));
        return model;
    }

private:
    // Each value takes at least its size, or in text a character and a blank.
    void check_count(const PlyElement& element)
    {
        std::size_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += ascii_ ? 2 : size_of(property.list ? property.count_type : property.type);
        if (element.count > (left() + 1) / least)
            fail(fmt::format("{} of element {} are declared, more than the {} bytes left can hold",
                             element.count, element.name, left()));
    }

    std::size_t left() const { return static_cast<std::size_t>(scan_.end - scan_.at); }

    // May be no finite number: infinity stands for what cannot be read in text.
    double value(PlyType type)
    {
        if (ascii_) {
            while (!scan_.done() && (is_blank(*scan_.at) || *scan_.at == '\n')) ++scan_.at;
            if (scan_.done()) fail("the file is cut off");
            const auto number = scan_.number();
            if (number && (scan_.done() || is_blank(*scan_.at) || *scan_.at == '\n'))
                return *number;
            scan_.word();
            return std::numeric_limits<double>::infinity();
        }
        const std::size_t size = size_of(type);
        if (left() < size) fail("the file is cut off");
        const double result = decoded(type, scan_.at, swap_);
        scan_.at += size;
        return result;
    }

    std::size_t list_length(const PlyProperty& property)
    {
        const double length = value(property.count_type);
        const std::size_t least = ascii_ ? 2 : size_of(property.type);
        if (!(length >= 0) || length != std::floor(length) ||
            length * static_cast<double>(least) > static_cast<double>(left() + 1))
            fail(
                fmt::format("a list's length is {}, more than the file holds or no count", length));
        return static_cast<std::size_t>(length);
    }

    void skip(const PlyProperty& property)
    {
        const std::size_t count = property.list ? list_length(property) : 1;
        for (std::size_t i = 0; i < count; ++i) value(property.type);
    }

    void skip(const PlyElement& element)
    {
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip(property);
    }

    // Where a property of the vertices goes: x y z, normal, colour, u v.
    static std::optional<std::size_t> slot(const std::string& name)
    {
        static const std::pair<std::string_view, std::size_t> slots[] = {
            {"x", 0},          {"y", 1},   {"z", 2},     {"nx", 3},   {"ny", 4},
            {"nz", 5},         {"red", 6}, {"green", 7}, {"blue", 8}, {"alpha", 9},
            {"u", 10},         {"v", 11},  {"s", 10},    {"t", 11},   {"texture_u", 10},
            {"texture_v", 11}, {"r", 6},   {"g", 7},     {"b", 8},    {"a", 9}};
        for (const auto& [known, at] : slots)
            if (known == name) return at;
        return {};
    }

    void read_vertices(const PlyElement& element)
    {
        bool have[12]{};
        double scale[12]{};
        for (const PlyProperty& property : element.properties)
            if (const auto at = slot(property.name); at && !property.list) {
                have[*at] = true;
                scale[*at] = property.type == PlyType::u8    ? 1 / 255.0
                             : property.type == PlyType::u16 ? 1 / 65535.0
                                                             : 1;
            }
        if (!have[0] || !have[1] || !have[2]) fail("the vertices have no x, y and z");
        const bool normals = have[3] && have[4] && have[5], colors = have[6] && have[7] && have[8];
        const bool uvs = have[10] && have[11];
        if (uvs && mesh_.uvs.empty()) mesh_.uvs.emplace_back();
        for (std::size_t i = 0; i < element.count; ++i) {
            if (i % (1 << 16) == 0)
                report(progress_, 0.3 * double(i) / double(element.count), "Reading vertices");
            double v[12]{};
            v[9] = 1 / (have[9] ? scale[9] : 1);
            for (const PlyProperty& property : element.properties) {
                const auto at = property.list ? std::nullopt : slot(property.name);
                if (!at)
                    skip(property);
                else
                    v[*at] = value(property.type);
            }
            for (std::size_t k = 0; k < 12; ++k) {
                if (std::abs(v[k]) <= std::numeric_limits<float>::max()) continue;
                if (k < 3)
                    fail(fmt::format("vertex {} has a coordinate that is no finite number", i));
                v[k] = 0;
                ++repaired_values_;
            }
            mesh_.positions.emplace_back(v[0], v[1], v[2]);
            if (normals) mesh_.normals.emplace_back(v[3], v[4], v[5]);
            if (colors) mesh_.colors.push_back(color(v, scale));
            if (uvs) mesh_.uvs[0].emplace_back(v[10], v[11]);
        }
    }

    // Whole numbers are display values, as scanners write them; fractions are linear light.
    static glm::vec4 color(const double* v, const double* scale)
    {
        glm::vec4 rgba(v[6] * scale[6], v[7] * scale[7], v[8] * scale[8],
                       scale[9] > 0 ? v[9] * scale[9] : 1);
        rgba = glm::clamp(rgba, 0.0f, 1.0f);
        if (scale[6] < 1) rgba = glm::vec4(linear_from_srgb(glm::vec3(rgba)), rgba.w);
        return rgba;
    }

    void read_faces(const PlyElement& element)
    {
        const auto is_corners = [](const PlyProperty& p) {
            return p.list && (p.name == "vertex_indices" || p.name == "vertex_index");
        };
        if (std::none_of(element.properties.begin(), element.properties.end(), is_corners))
            fail("the faces have no list of vertex_indices");
        for (std::size_t f = 0; f < element.count; ++f) {
            if (f % (1 << 16) == 0)
                report(progress_, 0.3 + 0.6 * double(f) / double(element.count), "Reading faces");
            for (const PlyProperty& property : element.properties) {
                if (!is_corners(property)) {
                    skip(property);
                    continue;
                }
                const std::size_t count = list_length(property);
                for (std::size_t c = 0; c < count; ++c) {
                    const double index = value(property.type);
                    if (!(index >= 0 && index < 1e9) || index != std::floor(index))
                        fail(fmt::format("face {} has something that is no vertex", f));
                    mesh_.corners.push_back(static_cast<std::uint32_t>(index));
                }
            }
            mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        }
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw Rejected(fmt::format("{}: {}", file_.name, what));
    }

    const FileText& file_;
    const Progress& progress_;
    PlyHeader header_;
    TextScan scan_;
    bool ascii_, swap_;
    Mesh mesh_;
    std::size_t repaired_values_ = 0;
};

} // namespace

Model read_ply(const FileText& file, const Progress& progress)
{
    return PlyReader(file, progress).read();
}

} // namespace trivar
