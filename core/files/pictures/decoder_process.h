// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

#include <cstdint>
#include <sys/types.h>

namespace trivar {

// DecoderLimits bound the decoding of a picture in another process.
struct DecoderLimits {
    std::uint64_t memory_bytes = 0; // in addition to those of the decoding program
    std::uint32_t cpu_s = 0;        // of the processor's time
};

// An DecoderProcess is the program trivar-picture, started for pictures whose kind has no
// trustworthy decoder: if that crashes, hangs or takes all memory, only this program ends. It does
// not confine a decoder that was taken over. Starting it takes a seventh of a second, a picture a
// millisecond more than here.
class DecoderProcess {
public:
    DecoderProcess(); // throws Rejected where the program is missing
    ~DecoderProcess();
    DecoderProcess(const DecoderProcess&) = delete;
    DecoderProcess& operator=(const DecoderProcess&) = delete;

    // Decodes like Codec::decode. Throws Rejected, with the rest of a sentence, if the program did
    // not survive the picture; the decoder then takes no more pictures.
    DecodeResult decode(const DecodeTask& task, const DecoderLimits& limits, const TakeRows& take);
    bool ended() const { return id_ < 0; }

private:
    void send(std::string_view bytes, int wait_ms);
    std::string received(std::uint64_t bytes, int wait_ms);
    bool waited(short event, int wait_ms);
    [[noreturn]] void fail(bool silent, const DecoderLimits& limits);
    int end(); // returns its status, as waitpid does

    pid_t id_ = -1;
    int line_ = -1;
};

} // namespace trivar
