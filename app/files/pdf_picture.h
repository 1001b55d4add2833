#pragma once

#include "app/texts/svg_picture.h"

#include <QByteArray>

namespace angiopose::app {

/// Returns the image as a PDF page of its size; paths stay paths and texts stay texts. Provenance is an attached file.
/// Empty if Qt cannot read the intermediate SVG.
QByteArray pdfOf(const ui::VectorPicture& picture, const SvgFacts& facts);

}   // namespace angiopose::app
