#pragma once

#include "app/texts/svg_picture.h"

#include <QByteArray>

namespace angiopose::app {

/// Returns the image as a PDF page of the same size, with lines as vectors and text as text; the provenance is an
/// attached file. Empty if Qt cannot read the intermediate SVG.
QByteArray toPdf(const ui::VectorImage& picture, const SvgMetadata& metadata);

}   // namespace angiopose::app
