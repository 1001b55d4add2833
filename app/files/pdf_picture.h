#pragma once

#include <QByteArray>
#include <QString>

#include <map>
#include <string>

namespace angiopose::app {

struct PdfFacts {
    QString title;
    std::map<std::string, std::string> texts;   ///< provenance: an attached file
    double dotsPerInch = 0.0;   ///< how many px of the picture make an inch; 0: those of a screen
};

/// An SVG picture as a page of PDF of its size: paths stay paths, texts become outlines. Empty where the SVG cannot be read.
QByteArray pdfOfSvg(const std::string& svg, const PdfFacts& facts);

}   // namespace angiopose::app
