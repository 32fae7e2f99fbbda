// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/volumes.h"

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace make {

Volume rounded(const Phantom& phantom)
{
    const std::vector<float> values = sampled(phantom);
    Volume out{phantom.size, phantom.step, {}};
    out.samples.reserve(values.size());
    for (const float value : values)
        out.samples.push_back(std::int16_t(std::lround(std::clamp(value, -1024.f, 3071.f))));
    return out;
}

void write_nrrd(const Volume& volume, const std::string& path)
{
    static_assert(std::endian::native == std::endian::little);
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: int16\ndimension: 3\nsizes: " << volume.size.x << " " << volume.size.y
         << " " << volume.size.z << "\nspacings: " << volume.step_mm << " " << volume.step_mm << " "
         << volume.step_mm << "\nunits: \"mm\" \"mm\" \"mm\"\nendian: little\nencoding: raw\n\n";
    file.write(reinterpret_cast<const char*>(volume.samples.data()),
               std::streamsize(volume.samples.size() * sizeof(std::int16_t)));
    if (!file) throw std::runtime_error("cannot write " + path);
}

std::vector<NamedVolume> volumes()
{
    return {{"jaw", [] { return rounded(jaw()); }},
            {"foot", [] { return rounded(foot()); }},
            {"neck", [] { return rounded(neck()); }},
            {"knee", [] { return rounded(knee()); }},
            {"protein", protein},
            {"silicon", silicon},
            {"caffeine", caffeine}};
}

} // namespace make
