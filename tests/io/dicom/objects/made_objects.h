#pragma once

#include "io/angiogram_file.h"
#include "io/dicom/objects/case_measurements.h"
#include "io/dicom/objects/encapsulated_pdf.h"
#include "io/dicom/objects/measurement_report.h"
#include "io/dicom/objects/presentation_state.h"
#include "io/dicom/objects/secondary_capture.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/dicom/objects/vessel_segmentation.h"
#include "io/scan_reference.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace angiopose::test {

/// A run of a patient whose name needs non-Latin letters, as a file, a scan of slices, and the objects made from both.
class MadeObjects : public ::testing::Test {
protected:
    void SetUp() override
    {
        core::Angiogram run;
        for (int k = 0; k < 3; ++k) {
            core::ImageF frame(20, 16);
            for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
                frame.pixels[i] = static_cast<float>((i * 37 + static_cast<std::size_t>(k) * 100) % 4096);
            }
            run.frames.push_back(std::move(frame));
        }
        run.frameTimeMs = 66.6;
        run.identity.patientName = "Müller^Ünal";
        run.identity.patientId = "P-17";
        run.identity.birthDate = "1950-03-01";
        run.identity.sex = "F";
        run.identity.studyDate = "2024-02-29";
        run.identity.accessionNumber = "A-9";
        run.identity.laterality = "L";
        ASSERT_TRUE(io::writeAngiogram(run, folder.file("run.dcm")));
        angiogram = source(folder.file("run.dcm"));
        writeScan();
    }

    io::SourceImage source(const std::string& path) const
    {
        auto read = io::readSourceImage(path);
        EXPECT_TRUE(read) << read.error().message;
        return read ? std::move(read).value() : io::SourceImage{};
    }

    /// Writes five slices of 8 × 9 voxels, 1.25 mm apart, rotated about the head-foot axis.
    void writeScan()
    {
        for (int k = 0; k < 5; ++k) {
            CtSlice slice;
            slice.sopInstanceUid = "1.2.3." + std::to_string(k + 1);
            slice.instanceNumber = k + 1;
            slice.orientation = {0.6, 0.8, 0.0, -0.8, 0.6, 0.0};
            slice.position = {-3.125, 7.75, 100.0 + 1.25 * k};
            slice.pixels.assign(72, static_cast<std::int16_t>(k));
            DicomBytes head;
            head.text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.2");
            folder.write("scan/" + std::to_string(k) + ".dcm",
                         std::string(128, '\0') + "DICM" + head.content() + ctSlice(slice).substr(132));
        }
        auto read = io::readScanReference(folder.file("scan"), "");
        ASSERT_TRUE(read) << read.error().message;
        scan = std::move(read).value();
    }

    core::VoxelMask vessels() const
    {
        core::VolumeGeometry grid;
        grid.size = {8, 9, 5};
        grid.spacingMm = {0.5, 0.75, 1.25};
        grid.originInPatient = {-3.125, 7.75, 100.0};
        grid.direction << 0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0;
        core::VoxelMask mask(grid);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            mask.voxels[i] = i % 7 == 3 || i % 11 == 0 ? 1 : 0;
        }
        return mask;
    }

    core::RigidTransform pose() const
    {
        core::RigidTransform pose;
        pose.rotation =
            (Eigen::AngleAxisd(1.234567890123, Eigen::Vector3d(0.3, -0.5, 0.81).normalized())).toRotationMatrix();
        pose.translation = {-12.345678901234567, 0.000123456789012345, 765.43210987654321};
        return pose;
    }

    io::CapturedImages images(int count) const
    {
        io::CapturedImages capture;
        for (int k = 0; k < count; ++k) {
            core::ColorImage picture{21, 15, {}};   // an odd number of bytes
            for (int i = 0; i < 21 * 15 * 3; ++i) {
                picture.rgb.push_back(static_cast<std::uint8_t>((i * 7 + k * 31) % 256));
            }
            capture.images.push_back(std::move(picture));
        }
        capture.frameTimeMs = 66.6;
        capture.derivation = "Vessels drawn over the image";
        return capture;
    }

    io::PresentationContent shownState() const
    {
        io::PresentationContent shown;
        shown.layers = {{"VESSELS", "Vessels", {80, 160, 250}, {{{0.0, 0.0}, {3.25, 7.5}, {19.0, 15.0}}}, {}},
                        {"NOTICE", "Notice", {200, 200, 200}, {}, {{"Not for clinical use, 血管", {2.0, 3.0}}}}};
        shown.frame = 1;
        shown.range = core::DisplayRange{100.0, 1100.0};
        shown.description = "Vessels as vectors";
        return shown;
    }

    io::MeasurementReport measured() const
    {
        io::ReportNumber length{io::lengthTerm, 12.345678901234567, {"mm", "UCUM", "millimeter"}, 2};
        length.pixels = {{1.0, 2.0}, {4.0, 6.0}};
        io::ReportNumber inScan{io::lengthTerm, 5.5, {"mm", "UCUM", "millimeter"}};
        inScan.pointsInPatient = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
        return {{{"Stenosis, Länge", {length}, {{{"121106", "DCM", "Comment"}, "at the vessels"}}},
                 {"In the scan", {inScan}}},
                "1.2.3.4"};
    }

    io::CArmRegistration registration() const
    {
        return {pose(),
                {-3500.25, 3501.5, 9.75, 7.25, 20, 16},
                "1.2.3.4",
                io::cameraFrameOfReference(angiogram, origin),
                "angiopose"};
    }

    /// All kinds of objects, by file name.
    std::vector<std::pair<std::string, core::Result<std::string>>> all() const
    {
        return {{"picture", io::encodeSecondaryCapture(images(1), angiogram, origin)},
                {"run", io::encodeMultiframeCapture(images(3), angiogram, origin)},
                {"report", io::encodeEncapsulatedPdf("%PDF-1.4\nodd", "Report of Müller",
                                                     io::BurnedInIdentity::Possible, angiogram, origin)},
                {"state", io::encodePresentationState(shownState(), angiogram, origin)},
                {"registration", io::encodeSpatialRegistration(registration(), angiogram, origin)},
                {"segmentation", io::encodeVesselSegmentation(vessels(), "drawn", scan, origin)},
                {"measurements", io::encodeMeasurementReport(measured(), angiogram, origin)}};
    }

    /// Path of the object written as a file; empty if it could not be made.
    std::string written(const std::string& name, const core::Result<std::string>& object) const
    {
        EXPECT_TRUE(object) << name << ": " << object.error().message;
        const std::string path = folder.file(name + "-object.dcm");
        writeText(path, object ? object.value() : std::string());
        return path;
    }

    TemporaryFolder folder;
    io::SourceImage angiogram;
    io::ScanReference scan;
    io::ObjectOrigin origin{"seed of a test", {"20260504", "123000"}, "Doe^Jane"};
};

}   // namespace angiopose::test
