// SPDX-License-Identifier: GPL-3.0-or-later
// Damages small sound files in ways that follow from a seed, and uses each as a program would.
#include "tests/fuzz/campaign_program.h"
#include "tests/fuzz/campaigns.h"

int main(int count, char** words)
{
    CLI::App app("Damages small sound files and uses each as a program would.");
    return trivar::testing::campaign_program(app, count, words, trivar::testing::all_campaigns);
}
