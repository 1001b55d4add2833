#pragma once

#include "app/texts/svg_picture.h"

#include <QByteArray>

namespace angiopose::app {

/// The picture as a page of PDF of its size: paths stay paths, texts stay texts. Provenance is an attached file. Empty
/// where Qt cannot read the SVG in between.
QByteArray pdfOf(const ui::VectorPicture& picture, const SvgFacts& facts);

}   // namespace angiopose::app
