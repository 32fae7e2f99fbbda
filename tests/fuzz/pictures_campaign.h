// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/pictures/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace trivar::testing {

struct DamagedPicture {
    std::string name, bytes;
};

// Damages whole pictures of one kind (sound_pictures.h): some bytes changed, cut off, a stretch
// left out or doubled, two joined, a number of the head replaced by an extreme one, with its
// checksum made right. Pure: the same seed and number give the same bytes.
class PicturesCampaign {
public:
    explicit PicturesCampaign(const std::string& extension);
    DamagedPicture damaged(std::uint64_t seed, int number) const;

private:
    std::string extension_;
    std::vector<std::string> sound_;
};

// Reads a picture like the program, as colours and as numbers. Returns why it was refused, empty:
// it was not. Throws std::logic_error if a promise is not kept: pixels of another number, a
// library's words.
std::string use_picture(const DamagedPicture& picture, PictureReader& reader);

} // namespace trivar::testing
