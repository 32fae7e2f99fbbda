// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_file.h"
#include "tests/fuzz/read_any_volume.h"

// Any bytes are a DICOM file whose pixels can be decoded, as many as it says, or Rejected; and a
// volume where it has many frames.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (!trivar::is_dicom(bytes)) return 0;
    try {
        const trivar::DicomHead head = trivar::read_dicom_head(bytes, "fuzz.dcm");
        if (head.frames.empty()) return 0;
        const trivar::TakenSamples taken = trivar::read_dicom_samples(bytes, head, "fuzz.dcm");
        const std::size_t count =
            std::visit([](const auto& samples) { return samples.size(); }, taken.samples);
        if (count != static_cast<std::size_t>(head.columns * head.rows) * head.frames.size())
            std::abort();
    } catch (const trivar::Rejected&) {
    }
    return trivar::testing::read_any_volume(data, size, "fuzz.dcm");
}
