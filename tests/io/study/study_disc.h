#pragma once

#include "core/imaging/angiogram.h"
#include "io/angiogram_file.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/io/study/dicomdir.h"
#include "tests/support/temporary_folder.h"

#include <string>
#include <vector>

namespace angiopose::test {

/// A DICOM structured report, without pixels.
inline std::string reportFile()
{
    DicomBytes data;
    data.text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.88.11");
    data.text(0x0008, 0x0018, "UI", "1.2.88.1");
    data.text(0x0008, 0x0020, "DA", "20260401");
    data.text(0x0008, 0x0023, "DA", "20260401");
    data.text(0x0008, 0x0033, "TM", "101010");
    data.text(0x0008, 0x0060, "CS", "SR");
    data.text(0x0010, 0x0010, "PN", "Phantom^CT");
    data.text(0x0010, 0x0020, "LO", "");
    data.text(0x0020, 0x000d, "UI", "1.2");
    data.text(0x0020, 0x000e, "UI", "1.2.88");
    data.text(0x0020, 0x0011, "IS", "9");
    data.text(0x0020, 0x0013, "IS", "1");
    data.text(0x0040, 0xa040, "CS", "CONTAINER");
    DicomBytes name;
    name.text(0x0008, 0x0100, "SH", "18748-4");
    name.text(0x0008, 0x0102, "SH", "LN");
    name.text(0x0008, 0x0104, "LO", "Diagnostic Imaging Report");
    data.sequence(0x0040, 0xa043, {name.content()});
    data.text(0x0040, 0xa491, "CS", "COMPLETE");
    data.text(0x0040, 0xa493, "CS", "UNVERIFIED");
    return data.content();
}

/// File meta information as discs have it, before a data set without.
inline std::string withMeta(const std::string& dataset, const std::string& sopClass, const std::string& sopInstance)
{
    DicomBytes meta;
    meta.bytes(0x0002, 0x0001, std::string("\0\1", 2));
    meta.text(0x0002, 0x0002, "UI", sopClass);
    meta.text(0x0002, 0x0003, "UI", sopInstance);
    meta.text(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.1");
    meta.text(0x0002, 0x0012, "UI", "1.2.3.4");
    return std::string(128, '\0') + "DICM" + meta.content() + dataset;
}

/// A run of three frames, a bright spot moving through it; of the patient and study of the slices.
inline core::Angiogram spotRun()
{
    core::Angiogram run;
    for (int k = 0; k < 3; ++k) {
        core::ImageF frame(128, 128);
        std::fill(frame.pixels.begin(), frame.pixels.end(), 10.0F);
        frame.at(16 + 48 * k, 16 + 48 * k) = 1000.0F;
        run.frames.push_back(frame);
    }
    run.frameTimeMs = 66.7;
    run.identity.patientName = "Phantom^CT";
    run.identity.studyDate = "2026-04-01";
    run.identity.studyUid = "1.2";
    run.identity.modality = "XA";
    return run;
}

/// A disc with a scan, a run, a report and the page of a viewer; the names of its DICOM files.
inline std::vector<std::string> writeDisc(const TemporaryFolder& folder)
{
    std::vector<std::string> names;
    for (const CtSlice& slice : allSlices(ctPhantom())) {
        const std::string name = "CT/IM" + std::to_string(slice.instanceNumber);
        const std::string sopClass = "1.2.840.10008.5.1.4.1.1.2";
        DicomBytes head;
        head.text(0x0008, 0x0016, "UI", sopClass);
        folder.write(name, withMeta(head.content() + ctSlice(slice).substr(132), sopClass, slice.sopInstanceUid));
        names.push_back(name);
    }
    folder.write("XA/RUN1", "");
    EXPECT_TRUE(io::writeAngiogram(spotRun(), folder.file("XA/RUN1.dcm")));
    std::filesystem::rename(folder.file("XA/RUN1.dcm"), folder.file("XA/RUN1"));
    names.push_back("XA/RUN1");
    folder.write("SR/REPORT", withMeta(reportFile(), "1.2.840.10008.5.1.4.1.1.88.11", "1.2.88.1"));
    names.push_back("SR/REPORT");
    folder.write("INDEX.HTM", "<html>viewer</html>");
    return names;
}

}   // namespace angiopose::test
