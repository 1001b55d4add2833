#include "io/dicom/objects/encapsulated_pdf.h"

#include "io/dicom/objects/coded_term.h"
#include "io/messages/messages.h"

namespace angiopose::io {
namespace {

constexpr ObjectKind pdfKind{"1.2.840.10008.5.1.4.1.1.104.1", "DOC", "report", "AngioPose report", 9003};
constexpr CodedTerm reportTitle{"126000", "DCM", "Imaging Measurement Report"};

}   // namespace

core::Result<std::string> encodeEncapsulatedPdf(std::string_view pdf, const std::string& title,
                                                BurnedInIdentity identity, const SourceImage& source,
                                                const ObjectOrigin& origin)
{
    if (!pdf.starts_with("%PDF-")) {
        return core::Error(messages::objectNoPdf());
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, pdfKind, source, origin);
    addContentTime(root, origin);
    root.text(0x0008002a, "DT", "");
    root.text(0x00080064, "CS", "WSD");
    root.text(0x00280301, "CS", identity == BurnedInIdentity::None ? "NO" : "YES");
    if (source.isReferenceable()) {
        addReference(root, 0x00420013, source.sopClassUid, source.sopInstanceUid);
    }
    addTerm(root, 0x0040a043, reportTitle);
    root.text(0x00420010, "ST", truncateUtf8(title, 1024));
    root.text(0x00420012, "LO", "application/pdf");
    root.bytes(0x00420011, pdf);
    root.setUnsignedLongs(0x00420015, {static_cast<std::uint32_t>(pdf.size())});
    return object.content();
}

}   // namespace angiopose::io
