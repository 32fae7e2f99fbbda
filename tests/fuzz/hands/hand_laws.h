// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/hands/hand.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trivar::testing {

// HandLaws hold whenever a hand rests, whatever it did. Each failure throws Broken.
//
//   the document   its log, written and read back, on disk too, gives the same
//   the past       what was committed before is the same as then, bit for bit
//   undo, redo     give the documents from before and after, and the same shapes
//   shapes         are those that a new evaluation gives; finite; closed where they came so
//   rest           nothing is proposed where no gesture, field or dialog is going on
//   words          are sentences of at most 400 printable bytes
class HandLaws {
public:
    explicit HandLaws(Hand& hand);
    void check(bool thoroughly); // thoroughly: with a new evaluation of all

private:
    struct KnownStep {
        Command command;
        std::string digest; // of the document after it
    };
    void check_words() const;
    void check_at_rest() const;
    void check_document() const;
    void check_past();
    void check_shapes() const;
    void check_way_back();
    void check_evaluation() const;
    using Shapes = std::map<Id, std::string>; // digests by object
    // None where they are not there, or where it would take long.
    std::optional<Shapes> shapes() const;
    void expect_shapes(const std::optional<Shapes>& then, const std::string& what) const;

    Hand& hand_;
    std::vector<KnownStep> known_; // those in force
    std::string start_;            // digest of the document before them
    std::optional<Shapes> shapes_;
    int frame_ = 0;
    long scene_ = 0;
};

} // namespace trivar::testing
