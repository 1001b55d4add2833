#pragma once

#include "io/dicom/dicom_dataset.h"

#include <optional>

namespace angiopose::io {

/// Private creator of the block in which Siemens systems store table and gantry positions, and the element that
/// reserves this block when writing.
inline constexpr const char* siemensCreator = "SIEMENS SMS-AX  ACQ 1.0";
inline constexpr DicomTag siemensBlock = 0x00210010;

inline constexpr DicomTag siemensIsocenter = 0x17;   ///< source-to-isocenter distance, mm
inline constexpr DicomTag siemensTableMoves = 0x24;   ///< 1 if the table moved during the cine run
inline constexpr DicomTag siemensTable = 0x57;   ///< table position: longitudinal, lateral, vertical, in 0.1 mm

/// Returns the tag of element (0021,xx`number`) of that block, wherever the block is; nullopt if the header has none.
std::optional<DicomTag> siemensTag(const DicomDataset& data, DicomTag number);

}   // namespace angiopose::io
