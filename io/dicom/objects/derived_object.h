#pragma once

#include "io/dicom/dicom_item.h"
#include "io/dicom/source_image.h"
#include "io/support/local_time.h"

#include <string>

namespace angiopose::io {

/// Properties shared by the objects that are exported from a case together.
struct ObjectOrigin {
    std::string seed;   ///< source of new UIDs: newUid(), or an earlier text for the same UIDs again
    LocalTime made;
    std::string author;   ///< may be empty

    /// The UID for a role, for example "series of the picture"; the same role gives the same UID.
    std::string uidFor(const std::string& role) const;
};

/// Creates an origin with a new seed.
ObjectOrigin newOrigin(const std::string& author);

/// The kind of an exported object.
struct ObjectKind {
    const char* sopClassUid;
    const char* modality;
    const char* role;   ///< a single word, used for UIDs
    const char* description;   ///< description of its series
    int seriesNumber;
};

/// Adds the modules of every object: SOP Common, Patient, General Study, Patient Study, General Series, General
/// Equipment (PS3.3 C.7, C.12.1). Patient and study are those of the source; without a source the object gets a study
/// of its own. States that this is research and not a medical device.
void addCommonModules(DicomItem& root, const ObjectKind& kind, const SourceImage& source, const ObjectOrigin& origin);

/// The study that the object belongs to.
std::string studyUidOf(const SourceImage& source, const ObjectOrigin& origin);

/// Adds the Content Identification macro (PS3.3 10.9): label in upper case, description for users, creator.
void addContentIdentification(DicomItem& root, const char* label, const std::string& description,
                              const ObjectOrigin& origin);

/// Adds Content Date and Content Time.
void addContentTime(DicomItem& root, const ObjectOrigin& origin);

/// Adds Derivation Description and Source Image Sequence (PS3.3 C.7.6.1), including earlier lossy compression of the
/// source.
void addDerivedFrom(DicomItem& root, const std::string& words, const SourceImage& source);

/// Adds the referenced series and instances of the study (PS3.3 C.12.2): one image.
void addReferencedSeries(DicomItem& root, const SourceImage& source);

}   // namespace angiopose::io
