// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/files/image.h"
#include "editor/picture/still.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Where the pictures of a sequence go: DIR/name.####.png, with a # for each digit of the number.
struct FrameNames {
    std::string before, after; // of the number
    int digits = 4;
    std::string path(int frame) const; // longer numbers take more digits
    std::string folder() const;        // "." where none is said
    std::string extension() const;     // .png or .exr
};
// Throws Rejected where the #'s are missing or apart, and for another extension.
FrameNames frame_names(const std::string& text);

// A:B or A:B:S: frames A to B, every Sth. One number is one frame. Throws Rejected.
std::vector<int> frames_of(std::string_view text);
// Throws Rejected where one of them is none of the scene's.
void check_frames(const std::vector<int>& frames, const Time& time);
// I/N, I from 1: every Nth of them, from the Ith on. Throws Rejected.
std::vector<int> share_of(const std::vector<int>& frames, std::string_view shard);

// A sequence of pictures, every one by itself: which files make it whole, and what they say of
// themselves, so that one which is there need not be drawn again.
struct Sequence {
    FrameNames names;
    glm::ivec2 size_px{0};
    int depth = 8;        // bits a channel of a PNG; EXR has half floats
    std::string log;      // digest of the scene file's text
    std::string settings; // what else decides what its pictures show
    bool deep() const { return depth == 16 || names.extension() == ".exr"; }
    // Whether that frame's file is whole and one of this sequence. Reads all of it.
    bool has(int frame, PictureReader& reader) const;
    // How many of the frames have no file, whatever is in those that are there.
    int gone(const std::vector<int>& frames) const;
    // What writes a frame that was drawn, on any thread: beside the file, flushed, then renamed.
    // It throws Rejected.
    std::function<void()> writer(int frame, const Still& still) const;
};
// What else than the log decides what its pictures show: words of who draws it, the program's
// version, a developer's shaders if there are any, and the files that the scene uses, as they were
// read. Throws Rejected where one is missing, unless that is well.
std::string sequence_settings(std::string drawn, const Document& document, const AssetStore& assets,
                              const Ref<gpu::ShaderTexts>& shaders = {},
                              bool missing_is_well = false);
std::string digest_of_log(std::string_view text);

// The folder of a file, made if only the last part of its name is missing. Throws Rejected.
void make_folder_of(const std::string& file);

// "3 min left", from what the ones before took; empty while nothing is known.
std::string time_left(int done, int of, double seconds);

} // namespace trivar
