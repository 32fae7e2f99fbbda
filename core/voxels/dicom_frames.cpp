// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_frames.h"

#include "core/files/file_sentences.h"
#include "core/voxels/dicom_dataset.h"

#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Finds where elements of a frame stand: in its own item of an enhanced multi-frame file, in the
// items shared by all frames, or at the top of any other file.
class FrameItems {
public:
    FrameItems(DcmDataset& data, unsigned long frame) : data_(data), frame_(frame) {}

    DcmItem* find(const DcmTagKey& sequence, const DcmTagKey& element) const
    {
        for (const auto& [groups, number] :
             {std::pair(DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(frame_)),
              std::pair(DCM_SharedFunctionalGroupsSequence, 0L)}) {
            DcmItem *group = nullptr, *item = nullptr;
            if (data_.findAndGetSequenceItem(groups, group, number).good() && group &&
                group->findAndGetSequenceItem(sequence, item, 0).good() && item &&
                item->tagExistsWithValue(element))
                return item;
        }
        return data_.tagExistsWithValue(element) ? &data_ : nullptr;
    }

    std::vector<double> numbers(const DcmTagKey& sequence, const DcmTagKey& element,
                                unsigned long count) const
    {
        DcmItem* const item = find(sequence, element);
        return item ? dicom_numbers(*item, element, count) : std::vector<double>();
    }

private:
    DcmDataset& data_;
    unsigned long frame_;
};

void take_orientation(DicomFrame& frame, const std::vector<double>& cosines,
                      const DicomDataset& file)
{
    constexpr double tolerance = 1e-2; // of lengths and of the right angle
    const glm::dvec3 row(cosines[0], cosines[1], cosines[2]);
    const glm::dvec3 column(cosines[3], cosines[4], cosines[5]);
    if (!(std::abs(glm::length(row) - 1) < tolerance) ||
        !(std::abs(glm::length(column) - 1) < tolerance) ||
        !(std::abs(glm::dot(row, column)) < tolerance))
        file.refuse("its ImageOrientationPatient should be two directions of length 1 at a right "
                    "angle");
    frame.along_row = glm::normalize(row);
    frame.along_column = glm::normalize(column);
}

// The frames of an older multi-frame file lie behind the first, evenly or as a list says.
void place_behind_first(DicomDataset& file, std::vector<DicomFrame>& frames)
{
    if (frames.size() == 1 || file.data().tagExistsWithValue(DCM_PerFrameFunctionalGroupsSequence))
        return;
    const DicomFrame first = frames[0];
    const glm::dvec3 normal = glm::cross(first.along_row, first.along_column);
    std::vector<double> offsets =
        dicom_numbers(file.data(), DCM_GridFrameOffsetVector, frames.size());
    if (offsets.empty()) {
        const auto apart = dicom_numbers(file.data(), DCM_SpacingBetweenSlices, 1);
        if (apart.empty() || apart[0] == 0)
            file.refuse(fmt::format("its {} frames have no places (PlanePositionSequence, "
                                    "GridFrameOffsetVector or SpacingBetweenSlices); this may be a "
                                    "film, not a volume",
                                    frames.size()));
        for (std::size_t k = 0; k < frames.size(); ++k)
            offsets.push_back(apart[0] * static_cast<double>(k));
    }
    for (std::size_t k = 0; k < frames.size(); ++k)
        frames[k].position = first.position + normal * (offsets[k] - offsets[0]);
}

void take_scale_of_values(DicomFrame& frame, const FrameItems& items, const DicomDataset& file)
{
    const auto slope = items.numbers(DCM_PixelValueTransformationSequence, DCM_RescaleSlope, 1);
    const auto intercept =
        items.numbers(DCM_PixelValueTransformationSequence, DCM_RescaleIntercept, 1);
    if (!slope.empty()) frame.slope = slope[0];
    if (!intercept.empty()) frame.intercept = intercept[0];
    if (frame.slope == 0) file.refuse("its RescaleSlope is 0, which makes all values one");
}

} // namespace

DicomFrames dicom_frames(DicomDataset& file, unsigned long count)
{
    DicomFrames out{std::vector<DicomFrame>(count)};
    for (unsigned long k = 0; k < count; ++k) {
        const FrameItems items(file.data(), k);
        DicomFrame& frame = out.frames[k];
        const auto position = items.numbers(DCM_PlanePositionSequence, DCM_ImagePositionPatient, 3);
        const auto cosines =
            items.numbers(DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient, 6);
        if (position.empty() || cosines.empty())
            file.refuse("it does not say where its slices lie (ImagePositionPatient and "
                        "ImageOrientationPatient)");
        frame.position = {position[0], position[1], position[2]};
        take_orientation(frame, cosines, file);
        auto spacing = items.numbers(DCM_PixelMeasuresSequence, DCM_PixelSpacing, 2);
        if (spacing.empty())
            spacing = items.numbers(DCM_PixelMeasuresSequence, DCM_ImagerPixelSpacing, 2);
        if (spacing.empty()) {
            out.spaced = false;
        } else {
            if (!(spacing[0] > 0 && spacing[1] > 0))
                file.refuse("its PixelSpacing should be two numbers above 0");
            frame.spacing = {spacing[1], spacing[0]}; // the file has that between rows first
        }
        take_scale_of_values(frame, items, file);
    }
    place_behind_first(file, out.frames);
    return out;
}

} // namespace trivar
