#include "io/dicom/objects/spatial_registration.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/new_uid.h"
#include "io/dicom/objects/coded_term.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/pose_matrix.h"

namespace angiopose::io {
namespace {

constexpr ObjectKind registrationKind{"1.2.840.10008.5.1.4.1.1.66.1", "REG", "registration",
                                      "AngioPose registration of scan and C-arm", 9005};
constexpr CodedTerm imageContentAlignment{"125024", "DCM", "Image Content-based Alignment"};
constexpr DicomTag registrationTag = 0x00700308;
constexpr DicomTag matrixRegistrationTag = 0x00700309;
constexpr DicomTag matrixSequenceTag = 0x0070030a;
constexpr DicomTag matrixTag = 0x300600c6;
constexpr DicomTag frameOfReferenceTag = 0x00200052;
constexpr const char* privateCreator = "ANGIOPOSE CAMERA 1";

std::vector<double> rowByRow(const core::RigidTransform& transform)
{
    const Eigen::Matrix4d matrix = transform.matrix();
    std::vector<double> values;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            values.push_back(matrix(row, column));
        }
    }
    return values;
}

void addMatrix(DicomItem& item, const core::RigidTransform& transform, const std::string& comment)
{
    DicomItem registration = item.addItem(matrixRegistrationTag);
    registration.text(0x300600c8, "LO", truncateUtf8(comment, 64));
    addTerm(registration, 0x0070030d, imageContentAlignment);
    DicomItem matrix = registration.addItem(matrixSequenceTag);
    matrix.setDecimals(matrixTag, rowByRow(transform));
    matrix.text(0x0070030c, "CS", "RIGID");
}

void addScanItem(DicomItem& root, const CArmRegistration& registration)
{
    DicomItem item = root.addItem(registrationTag);
    item.text(frameOfReferenceTag, "UI", registration.scanFrameOfReferenceUid);
    addMatrix(item, registration.cameraFromPatient, "Patient (LPS mm of the scan) to X-ray camera (mm)");
}

void addCameraItem(DicomItem& root, const CArmRegistration& registration, const SourceImage& angiogram)
{
    DicomItem item = root.addItem(registrationTag);
    if (angiogram.isReferenceable()) {
        addReference(item, 0x00081140, angiogram.sopClassUid, angiogram.sopInstanceUid);
    }
    item.text(frameOfReferenceTag, "UI", registration.cameraFrameOfReferenceUid);
    addMatrix(item, core::RigidTransform{}, "X-ray camera itself");
}

/// Adds pose and camera with full double precision as private elements, because the standard has no elements for these.
void addCamera(DicomItem& root, const CArmRegistration& registration)
{
    const core::ProjectionCamera& camera = registration.camera;
    root.text(0x00710010, "LO", privateCreator);
    root.setDoubles(0x00711001, rowByRow(registration.cameraFromPatient));
    root.setDoubles(0x00711002, {camera.fx, camera.fy, camera.cx, camera.cy});
    root.setUnsignedShorts(0x00711003,
                           {static_cast<std::uint16_t>(camera.width), static_cast<std::uint16_t>(camera.height)});
    root.text(0x00711004, "LO", truncateUtf8(registration.method, 64));
    root.text(0x00711005, "LT",
              "u = fx X/Z + cx, v = fy Y/Z + cy; (X, Y, Z) in mm is the camera point of a patient point (1001: matrix "
              "cameraFromPatient, row by row), Z from the X-ray source to the detector; 1002: fx, fy, cx, cy in px, "
              "(0, 0) the centre of the first pixel; 1003: columns, rows.");
}

/// Reads the pose from the values of an element; returns nullopt if a value is missing.
std::optional<core::Result<core::RigidTransform>> poseIn(const DicomDataset& data, DicomTag tag)
{
    MatrixRows rows(4, std::vector<double>(4));
    for (std::size_t i = 0; i < 16; ++i) {
        const auto value = data.number(tag, i);
        if (!value) {
            return std::nullopt;
        }
        rows[i / 4][i % 4] = *value;
    }
    return poseFromRows(rows);
}

/// Returns the matrices of the items whose frame of reference differs from that of the object.
std::vector<DicomDataset> matricesToOwnFrame(const DicomDataset& data)
{
    std::vector<DicomDataset> matrices;
    for (const DicomDataset& item : data.items(registrationTag)) {
        if (item.text(frameOfReferenceTag) == data.text(frameOfReferenceTag)) {
            continue;
        }
        for (const DicomDataset& registration : item.items(matrixRegistrationTag)) {
            const std::vector<DicomDataset> steps = registration.items(matrixSequenceTag);
            matrices.insert(matrices.end(), steps.begin(), steps.end());
        }
    }
    return matrices;
}

}   // namespace

std::string cameraFrameOfReference(const SourceImage& angiogram, const ObjectOrigin& origin)
{
    return angiogram.sopInstanceUid.empty() ? origin.uidFor("camera")
                                            : uidFromContent("camera of " + angiogram.sopInstanceUid);
}

core::Result<std::string> encodeSpatialRegistration(const CArmRegistration& registration, const SourceImage& angiogram,
                                                    const ObjectOrigin& origin)
{
    if (!core::isRigid(registration.cameraFromPatient)) {
        return core::Error(messages::objectPoseNotRigid());
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, registrationKind, angiogram, origin);
    addContentIdentification(root, "ANGIOPOSE", "Patient of the scan to X-ray camera, rigid; camera is private",
                             origin);
    addContentTime(root, origin);
    root.text(frameOfReferenceTag, "UI", registration.cameraFrameOfReferenceUid);
    root.text(0x00201040, "LO", "");
    addReferencedSeries(root, angiogram);
    addScanItem(root, registration);
    addCameraItem(root, registration, angiogram);
    addCamera(root, registration);
    return object.content();
}

core::Result<core::RigidTransform> readSpatialRegistration(std::string_view content, const std::string& path)
{
    const auto file = parseDicom(content, path);
    if (!file) {
        return file.error();
    }
    const DicomDataset& data = file.value().dataset;
    const std::vector<DicomDataset> matrices = matricesToOwnFrame(data);
    const auto pose = matrices.size() == 1 ? poseIn(matrices.front(), matrixTag) : std::nullopt;
    if (!pose) {
        return fileError(path, messages::poseNoRegistration());
    }
    return *pose ? *pose : fileError(path, pose->error());
}

}   // namespace angiopose::io
