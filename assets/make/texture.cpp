// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/texture.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

struct Atlas {
    glm::ivec2 size_px;
    std::vector<vec3> points;  // of the surface behind each texel
    std::vector<char> covered; // whether there is one

    std::size_t at(int x, int y) const
    {
        const int column = (x % size_px.x + size_px.x) % size_px.x;
        return std::size_t(std::clamp(y, 0, size_px.y - 1)) * std::size_t(size_px.x) +
               std::size_t(column);
    }

    void draw(const std::array<vec2, 3>& uv, const std::array<vec3, 3>& p)
    {
        const auto area = [](vec2 a, vec2 b, vec2 c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        };
        const float whole = area(uv[0], uv[1], uv[2]);
        if (std::abs(whole) < 1e-9f) return;
        const vec2 lo = glm::floor(glm::min(uv[0], glm::min(uv[1], uv[2])));
        const vec2 hi = glm::ceil(glm::max(uv[0], glm::max(uv[1], uv[2])));
        constexpr float slack = -1e-4f; // texels on an edge belong to both faces
        for (int y = std::max(0, int(lo.y)); y < std::min(size_px.y, int(hi.y)); ++y) {
            for (int x = int(lo.x); x < int(hi.x); ++x) {
                const vec2 q(float(x) + .5f, float(y) + .5f);
                const float a = area(q, uv[1], uv[2]) / whole, b = area(uv[0], q, uv[2]) / whole;
                if (a < slack || b < slack || 1 - a - b < slack) continue;
                points[at(x, y)] = a * p[0] + b * p[1] + (1 - a - b) * p[2];
                covered[at(x, y)] = 1;
            }
        }
    }
};

Atlas unwrap(const Mesh& mesh, glm::ivec2 size_px)
{
    const auto texels = std::size_t(size_px.x) * std::size_t(size_px.y);
    Atlas atlas{size_px, std::vector<vec3>(texels), std::vector<char>(texels, 0)};
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Face& q = mesh.faces[f];
        for (std::size_t k = 1; k + 1 < corner_count(q); ++k) {
            const auto uv = [&](std::size_t c) { return mesh.uvs[f][c] * vec2(size_px); };
            atlas.draw({uv(0), uv(k), uv(k + 1)},
                       {mesh.points[q[0]], mesh.points[q[k]], mesh.points[q[k + 1]]});
        }
    }
    return atlas;
}

// One ring of uncovered texels takes the mean of its covered neighbours. False: nothing was left.
bool grow(Atlas& atlas, std::vector<vec3>& colors)
{
    std::vector<std::pair<std::size_t, vec3>> rim;
    for (int y = 0; y < atlas.size_px.y; ++y) {
        for (int x = 0; x < atlas.size_px.x; ++x) {
            if (atlas.covered[atlas.at(x, y)]) continue;
            vec3 sum(0);
            int count = 0;
            for (const glm::ivec2 d : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const std::size_t i = atlas.at(x + d.x, y + d.y);
                if (!atlas.covered[i]) continue;
                sum += colors[i];
                ++count;
            }
            if (count) rim.emplace_back(atlas.at(x, y), sum / float(count));
        }
    }
    for (const auto& [i, color] : rim) {
        colors[i] = color;
        atlas.covered[i] = 1;
    }
    return !rim.empty();
}

std::string big_endian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(char(value >> shift & 255));
    return bytes;
}

std::uint32_t crc32(const std::string& bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (char c : bytes) {
        crc ^= std::uint8_t(c);
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& data)
{
    return big_endian(std::uint32_t(data.size())) + type + data + big_endian(crc32(type + data));
}

// RFC 1950 and 1951: stored blocks of at most 65535 bytes.
std::string zlib_stored(const std::string& data)
{
    std::string out = "\x78\x01";
    for (std::size_t begin = 0; begin < data.size(); begin += 65535) {
        const std::size_t length = std::min<std::size_t>(65535, data.size() - begin);
        out.push_back(begin + length == data.size() ? 1 : 0);
        for (const std::size_t n : {length, ~length}) {
            out.push_back(char(n & 255));
            out.push_back(char(n >> 8 & 255));
        }
        out += data.substr(begin, length);
    }
    std::uint32_t a = 1, b = 0; // Adler-32
    for (char c : data) {
        a = (a + std::uint8_t(c)) % 65521;
        b = (b + a) % 65521;
    }
    return out + big_endian(b << 16 | a);
}

} // namespace

Texture bake(const Mesh& mesh, glm::ivec2 size_px, const std::function<vec3(vec3)>& color)
{
    constexpr int rings = 8; // as far as the coarser mip levels that matter reach
    Atlas atlas = unwrap(mesh, size_px);
    std::vector<vec3> colors(atlas.points.size(), vec3(.5f));
    trivar::parallel_blocks(colors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (atlas.covered[i]) colors[i] = color(atlas.points[i]);
        }
    });
    for (int ring = 0; ring < rings && grow(atlas, colors); ++ring) {
    }
    Texture texture{size_px, {}};
    for (const vec3& c : colors) {
        for (int i = 0; i < 3; ++i) {
            texture.rgb.push_back(std::uint8_t(glm::clamp(c[i], 0.f, 1.f) * 255.f + .5f));
        }
    }
    return texture;
}

std::string png(const GreyPicture& picture)
{
    std::string rows;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (i % std::size_t(picture.size_px.x) == 0) rows.push_back(0); // no filter
        const auto value = std::uint16_t(glm::clamp(picture.values[i], 0.f, 1.f) * 65535.f + .5f);
        rows.push_back(char(value >> 8));
        rows.push_back(char(value & 255));
    }
    const std::string header = big_endian(std::uint32_t(picture.size_px.x)) +
                               big_endian(std::uint32_t(picture.size_px.y)) +
                               std::string("\x10\0\0\0\0", 5); // 16 bits, grey
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", zlib_stored(rows)) +
           chunk("IEND", "");
}

std::string png(const Texture& texture)
{
    std::string rows;
    const auto stride = std::size_t(texture.size_px.x) * 3;
    for (std::size_t y = 0; y < std::size_t(texture.size_px.y); ++y) {
        rows.push_back(0); // no filter
        const auto* row = reinterpret_cast<const char*>(texture.rgb.data()) + y * stride;
        rows.append(row, stride);
    }
    const std::string header = big_endian(std::uint32_t(texture.size_px.x)) +
                               big_endian(std::uint32_t(texture.size_px.y)) +
                               std::string("\x08\x02\0\0\0", 5); // 8 bits, RGB
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", zlib_stored(rows)) +
           chunk("IEND", "");
}

} // namespace make
