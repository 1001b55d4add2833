#pragma once

#include "io/dicom/dicom_dataset.h"

#include <optional>

namespace angiopose::io {

/// The creator of the private block in which Siemens rooms note table and gantry, and its first place when it is
/// written.
inline constexpr const char* siemensCreator = "SIEMENS SMS-AX  ACQ 1.0";
inline constexpr DicomTag siemensBlock = 0x00210010;

inline constexpr DicomTag siemensIsocenter = 0x17;   ///< mm
inline constexpr DicomTag siemensTableMoves = 0x24;   ///< 1: during the run
inline constexpr DicomTag siemensTable = 0x57;   ///< longitudinal, lateral, vertical, 0.1 mm

/// The element (0021,xx`number`) of that block, wherever the block lies; nothing where the header has none.
std::optional<DicomTag> siemensTag(const DicomDataset& data, DicomTag number);

}   // namespace angiopose::io
