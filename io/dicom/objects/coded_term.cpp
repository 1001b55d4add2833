#include "io/dicom/objects/coded_term.h"

namespace angiopose::io {

DicomItem addTerm(DicomItem& item, DicomTag sequence, const CodedTerm& term)
{
    DicomItem code = item.addItem(sequence);
    code.text(0x00080100, "SH", term.value);
    code.text(0x00080102, "SH", term.scheme);
    code.text(0x00080104, "LO", term.meaning);
    return code;
}

}   // namespace angiopose::io
