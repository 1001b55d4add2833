#pragma once

#include "io/dicom/dicom_item.h"
#include "io/dicom/source_image.h"
#include "io/support/local_time.h"

#include <string>

namespace angiopose::io {

/// Properties shared by the objects that are exported from a case together.
struct ObjectOrigin {
    std::string seed;   ///< seed of the new UIDs: newUid(), or an earlier seed to reproduce its UIDs
    LocalTime created;
    std::string author;   ///< name of the author; may be empty

    /// Returns the UID for a role, for example "series of the image"; equal roles have equal UIDs.
    std::string uidFor(const std::string& role) const;
};

/// Creates an origin with a new seed.
ObjectOrigin makeOrigin(const std::string& author);

/// The kind of an exported object.
struct ObjectKind {
    const char* sopClassUid;
    const char* modality;
    const char* role;   ///< single word from which the UIDs are derived
    const char* description;   ///< series description
    int seriesNumber;
};

/// Adds the modules that all objects have: SOP Common, Patient, General Study, Patient Study, General Series, General
/// Equipment (PS3.3 C.7, C.12.1). Copies patient and study from the source; an object without a source gets a new
/// study. States that the object is for research use and that AngioPose is not a medical device.
void addCommonModules(DicomItem& root, const ObjectKind& kind, const SourceImage& source, const ObjectOrigin& origin);

/// Returns the UID of the study to which the object belongs.
std::string studyUidOf(const SourceImage& source, const ObjectOrigin& origin);

/// Adds the Content Identification macro (PS3.3 10.9): upper-case label, description for readers, creator.
void addContentIdentification(DicomItem& root, const char* label, const std::string& description,
                              const ObjectOrigin& origin);

/// Adds Content Date and Content Time.
void addContentTime(DicomItem& root, const ObjectOrigin& origin);

/// Adds Derivation Description and Source Image Sequence (PS3.3 C.7.6.1), and the lossy compression history of the
/// source.
void addDerivedFrom(DicomItem& root, const std::string& words, const SourceImage& source);

/// Adds the source image as the only referenced instance of its series (PS3.3 C.12.2).
void addReferencedSeries(DicomItem& root, const SourceImage& source);

}   // namespace angiopose::io
