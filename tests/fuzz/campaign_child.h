// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"
#include "tests/fuzz/case_result.h"

#include <filesystem>

namespace trivar::testing {

// A CaseFolder holds the files of a case, and the output of libraries on it.
struct CaseFolder {
    std::filesystem::path path;
    std::filesystem::path files() const { return path / "case"; }
    std::filesystem::path said() const { return path / "said.txt"; }
};

// Makes the files of one case in the folder and does with them what the campaign says.
CaseResult run_case(const Campaign& campaign, const CampaignOptions& options, int number,
                    const CaseFolder& folder);

// Runs the cases from `first` on in this process, within limits of memory and of written bytes, and
// ends it. The lines of case_result.h go to the file `report`.
[[noreturn]] void run_cases(const CampaignEntry& entry, const CampaignOptions& options, int first,
                            const CaseFolder& folder, int report);

// Copies the files of a case that failed, with what is known of it, into a folder of their own in
// the one that the options name.
void keep_case(const CampaignEntry& entry, const CampaignOptions& options, const CaseResult& result,
               const CaseFolder& folder);

} // namespace trivar::testing
