#pragma once

#include "io/dicom/dicom_item.h"
#include "io/dicom/source_image.h"
#include "io/support/local_time.h"

#include <string>

namespace angiopose::io {

/// What the objects that leave a case at once have in common.
struct ObjectOrigin {
    std::string seed;   ///< what new UIDs follow from: newUid(), or the same text for the same UIDs again
    LocalTime made;
    std::string author;   ///< may be empty

    /// The UID of this origin for a role, "series of the picture": one role, one UID.
    std::string uidFor(const std::string& role) const;
};

/// An origin that never was before.
ObjectOrigin newOrigin(const std::string& author);

/// What kind of object it is.
struct ObjectKind {
    const char* sopClassUid;
    const char* modality;
    const char* role;   ///< one word, for UIDs
    const char* description;   ///< of its series
    int seriesNumber;
};

/// The modules that every object has: SOP Common, Patient, General Study, Patient Study, General Series, General
/// Equipment (PS3.3 C.7, C.12.1). Patient and study are the source's; without one it is a study of its own. Says that
/// this is research and no medical device.
void addCommonModules(DicomItem& root, const ObjectKind& kind, const SourceImage& source, const ObjectOrigin& origin);

/// The study that the object belongs to.
std::string studyUidOf(const SourceImage& source, const ObjectOrigin& origin);

/// Content Identification macro (PS3.3 10.9): label in capitals, words for people, who made it.
void addContentIdentification(DicomItem& root, const char* label, const std::string& description,
                              const ObjectOrigin& origin);

/// Content Date and Content Time.
void addContentTime(DicomItem& root, const ObjectOrigin& origin);

/// Derivation Description and Source Image Sequence (PS3.3 C.7.6.1), with what the source had lost before.
void addDerivedFrom(DicomItem& root, const std::string& words, const SourceImage& source);

/// The study's series and instances that an object refers to (PS3.3 C.12.2): one image.
void addReferencedSeries(DicomItem& root, const SourceImage& source);

}   // namespace angiopose::io
