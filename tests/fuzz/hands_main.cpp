// SPDX-License-Identifier: GPL-3.0-or-later
// Makes gestures in the window, without a screen, that follow from a seed.
#include "tests/fuzz/campaign_program.h"
#include "tests/fuzz/hands/hands_campaign.h"

#include <cstdlib>

int main(int count, char** words)
{
    ::setenv("LP_NUM_THREADS", "0", 0); // pictures are drawn by the thread that asks for them
    trivar::testing::HandsOptions options;
    CLI::App app("Makes gestures in the window and looks whether all that must hold still does.");
    app.add_option("--gestures", options.gestures, "number of gestures in a case")
        ->capture_default_str();
    app.add_option("--longest-frame", options.longest_frame_s,
                   "seconds of the processor that a frame may take; 0: it is not judged");
    return trivar::testing::campaign_program(
        app, count, words, [&] { return trivar::testing::hands_campaigns(options); });
}
