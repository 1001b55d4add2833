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

/// What a set of files turned out to be: a whole case, or parts of one.
struct LoadedInputs {
    std::optional<core::Case> wholeCase;
    core::InputFile centerlineFile;
    core::VesselInput vesselInput;
    std::shared_ptr<const core::Volume> volume;
    std::shared_ptr<const core::VoxelMask> lumen;
    core::StudyIdentity scanIdentity;
    core::InputFile scanFile;   ///< of a scan that is to be seen only: `volume` without a tree
    std::string scanSeriesId;   ///< of `scanFile`, where that is a DICOM folder
    bool isStudyOffered = false;   ///< a folder or DICOMDIR alone: nothing was read, see OpenHints::offersStudies
    bool isScanAsked = false;   ///< it is a scan: nothing was read, see ScanUse::Ask
    /// How many units vessels are across that say no unit and are too small or large for mm: nothing else was read.
    std::optional<double> askedUnitsAcross;
    std::shared_ptr<const core::VesselTree> tree;
    core::InputFile imageFile;
    std::shared_ptr<const core::Angiogram> angiogram;
    std::shared_ptr<const core::Angiogram>
        storedRun;   ///< as the file has it, where its header subtracts it; else null
    core::SubtractionPlan headerPlan;   ///< of the angiogram
    core::InputFile targetFile;
    std::shared_ptr<const core::Centerline2d> target;
    std::optional<PoseWithCamera> pose;   ///< of a pose file: nothing else was read
    std::vector<Fiducial> fiducials;   ///< of a file of points: nothing else was read
    core::Messages warnings;
    std::vector<DicomSeries> offered;   ///< of a folder with several: nothing is read until one is chosen
    std::vector<MissingInput> missing;   ///< of a case, found nowhere: nothing else is read
    MovedInputs moved;   ///< inputs of the case that were found elsewhere
};

/// What a scan is opened for: its vessels, the same or, where none are found, to be seen, or to be seen beside vessels
/// that are there.
enum class ScanUse { Trace, TraceOrShow, Beside, Ask };

/// What helps to open files beside their paths.
struct OpenHints {
    std::string seriesId;   ///< of a DICOM folder among them; empty: where there are several, they are offered
    MovedInputs moved;   ///< where inputs of a case lie now
    std::vector<std::string> searchFolders;   ///< where inputs of a case are looked for that are not in their place
    ScanUse scanUse = ScanUse::Trace;   ///< Ask: a scan is not read but told
    std::optional<double> unitMm =
        std::nullopt;   ///< of vessels among them; not set: mm where that is plausible, else it is told
    /// How vessels among them are read and traced; not set: as their content asks for.
    std::optional<core::VesselInput> vessels = std::nullopt;
    bool offersStudies = false;   ///< a folder or DICOMDIR alone is not read: what lies in it is to be chosen first
    bool withoutOptional = false;   ///< a case opens without what it can do without and is found nowhere
};

}   // namespace angiopose::io
