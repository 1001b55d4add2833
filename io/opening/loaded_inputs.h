#pragma once

#include "core/case/case.h"
#include "io/case/moved_inputs.h"
#include "io/dicom_series.h"
#include "io/pose_camera_file.h"
#include "io/vessel/fiducial.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// The contents of a set of files: a whole case, or parts of one.
struct LoadedInputs {
    std::optional<core::Case> loadedCase;
    core::InputFile centerlineFile;
    core::VesselInput vesselInput;
    std::shared_ptr<const core::Volume> volume;
    std::shared_ptr<const core::VoxelMask> lumen;
    core::StudyIdentity scanIdentity;
    core::InputFile scanFile;   ///< scan that is only displayed: `volume` without a tree
    std::string scanSeriesId;   ///< series of `scanFile`, if the scan is a DICOM folder
    bool isStudyChoiceNeeded =
        false;   ///< only a folder or DICOMDIR was opened and nothing was read; see OpenHints::offersStudies
    bool isScanUseUndecided = false;   ///< whether the file is a scan of which nothing was read; see ScanUse::Ask
    /// Extent, in file units, of vessels whose file states no unit, if they would be implausibly small or large in mm;
    /// nothing else was read.
    std::optional<double> extentInUnknownUnits;
    std::shared_ptr<const core::VesselTree> tree;
    core::InputFile imageFile;
    std::shared_ptr<const core::Angiogram> angiogram;
    std::shared_ptr<const core::Angiogram>
        storedRun;   ///< run as stored if its header requests subtraction; null otherwise
    core::SubtractionPlan headerPlan;   ///< subtraction plan from the image header
    core::InputFile targetFile;
    std::shared_ptr<const core::Centerline2d> target;
    std::optional<PoseWithCamera> pose;   ///< contents of a pose file; nothing else was read
    std::vector<Fiducial> fiducials;   ///< contents of a point file; nothing else was read
    core::Messages warnings;
    std::vector<DicomSeries> offeredSeries;   ///< series of a folder with several; nothing is read before one is chosen
    std::vector<MissingInput> missing;   ///< inputs of the case that were not found; nothing else was read
    MovedInputs moved;   ///< inputs of the case that were found elsewhere
};

/// Use of an opened scan. `Trace`: trace its vessels; `TraceOrShow`: show the scan if no vessels are found;
/// `ShowWithVessels`: show it with the existing vessels; `Ask`: let the user decide.
enum class ScanUse { Trace, TraceOrShow, ShowWithVessels, Ask };

/// Options for opening files, in addition to their paths.
struct OpenHints {
    std::string seriesId;   ///< series to read from a DICOM folder; if empty, several series are offered to choose from
    MovedInputs moved;   ///< current locations of the inputs of a case
    std::vector<std::string> searchFolders;   ///< folders to search for missing inputs of a case
    ScanUse scanUse = ScanUse::Trace;   ///< with `Ask`, a scan is only reported, not read
    std::optional<double> unitMm =
        std::nullopt;   ///< unit of the vessel files; if not set, mm if plausible, otherwise see `extentInUnknownUnits`
    /// Settings for reading and tracing vessel files; if not set, the file contents decide.
    std::optional<core::VesselInput> vessels = std::nullopt;
    bool offersStudies =
        false;   ///< if true, a folder or DICOMDIR that is opened alone is not read; the user chooses from its series
    bool skipsOptionalInputs = false;   ///< if true, a case opens even if optional inputs are missing
};

}   // namespace angiopose::io
