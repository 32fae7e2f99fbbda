// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// DCMTK's headers: for the sources of this room that read DICOM only.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A DICOM file as DCMTK has it. The bytes must outlive it. Throws Rejected where it is damaged or
// cut.
class DicomDataset {
public:
    DicomDataset(std::string_view bytes, std::string name);
    DcmDataset& data() { return *file_.getDataset(); }
    [[noreturn]] void refuse(std::string_view reason) const; // throws Rejected

private:
    DcmFileFormat file_;
    std::string name_;
};

// The value of an element without the blanks around it; empty where there is none.
std::string dicom_text(DcmItem& item, const DcmTagKey& tag);

// The first `count` numbers of an element; empty where there are fewer, or one is not finite.
std::vector<double> dicom_numbers(DcmItem& item, const DcmTagKey& tag, unsigned long count);

} // namespace trivar
