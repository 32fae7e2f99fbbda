// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_source.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

VolumeSource::VolumeSource(std::string_view bytes, std::string name, const std::string& folder,
                           std::uintmax_t most_bytes)
    : bytes_(bytes),
      name_(std::move(name)),
      files_(folder),
      bytes_left_(most_bytes - std::min<std::uintmax_t>(most_bytes, bytes.size()))
{
}

std::string VolumeSource::beside(std::string_view name)
{
    const auto found = files_.find(name);
    if (!found)
        refuse(fmt::format("it names the file '{}', which is not in its folder", shown(name)));
    companions_.insert(found->name);
    return found->path;
}

std::string VolumeSource::read_beside(std::string_view name)
{
    std::string bytes = trivar::read_bytes(beside(name), bytes_left_);
    bytes_left_ -= bytes.size();
    return bytes;
}

void VolumeSource::refuse(std::string_view reason) const
{
    throw Rejected(fmt::format("{}: {}", name_, reason));
}

void VolumeSource::say(std::string_view sentence)
{
    notices_.push_back(fmt::format("{}: {}", name_, sentence));
}

} // namespace trivar
