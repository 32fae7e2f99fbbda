// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/asset_store.h"
#include "core/files/pictures/image.h"
#include "editor/picture/still.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// FrameNames says where the pictures of a sequence go: DIR/name.####.png, with one # per digit of
// the number.
struct FrameNames {
    std::string before, after; // of the number
    int digits = 4;
    std::string path(int frame) const; // longer numbers take more digits
    std::string folder() const;        // "." where none is said
    std::string extension() const;     // .png or .exr
};
// Throws Rejected where the #'s are missing or separated, and for another extension.
FrameNames frame_names(const std::string& text);

// A:B or A:B:S: frames A to B, every Sth. One number is one frame. Throws Rejected.
std::vector<int> frames_of(std::string_view text);
// Throws Rejected where a frame is outside the scene's.
void check_frames(const std::vector<int>& frames, const Time& time);
// The share I/N of the frames, with I from 1: every Nth frame, beginning with the Ith. Throws
// Rejected.
std::vector<int> share_of(const std::vector<int>& frames, std::string_view shard);

// A Sequence is a sequence of picture files: which files belong to it, and what they say of
// themselves, so that an existing picture need not be drawn again.
struct Sequence {
    FrameNames names;
    glm::ivec2 size_px{0};
    int depth = 8;        // bits a channel of a PNG; EXR has half floats
    std::string log;      // digest of the scene file's text
    std::string settings; // what else decides what its pictures show
    bool deep() const { return depth == 16 || names.extension() == ".exr"; }
    // Whether that frame's file is complete and belongs to this sequence. Reads the whole file.
    bool has(int frame, PictureReader& reader) const;
    // The number of frames without a file; the content of existing files does not matter.
    int gone(const std::vector<int>& frames) const;
    // A function that writes a drawn frame, on any thread: beside the file, flushed, then renamed.
    // It throws Rejected.
    std::function<void()> writer(int frame, const Still& still) const;
};
// The settings besides the log that decide what the pictures show: a description of the renderer,
// the program's version, a developer's shaders if there are any, and the files that the scene uses,
// as they were read. Throws Rejected where a file is missing, unless that is allowed.
std::string sequence_settings(std::string drawn, const Document& document, const AssetStore& assets,
                              const Ref<gpu::ShaderTexts>& shaders = {},
                              bool missing_is_well = false);
std::string digest_of_log(std::string_view text);

// The folder of a file, made if only the last part of its name is missing. Throws Rejected.
void make_folder_of(const std::string& file);

// "3 min left", estimated from the previous ones; empty while nothing is known.
std::string time_left(int done, int of, double seconds);

} // namespace trivar
