// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/sentence.h"

#include <string>

namespace trivar::testing {

// Gives what `run` gives, which must not be refused any more: that throws Broken.
template <class Run> auto promised(const std::string& what, Run&& run)
{
    try {
        return run();
    } catch (const Rejected& rejected) {
        throw Broken(what + ": " + rejected.what());
    }
}

// Whether `run` was not refused; it may be, in a sound sentence.
template <class Run> bool allowed(Run&& run)
{
    try {
        run();
        return true;
    } catch (const Rejected& rejected) {
        check_sentences({rejected.what()});
        return false;
    }
}

} // namespace trivar::testing
