#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace angiopose::test {

/// Describes every visible label, button and field below the widget whose text does not fit. Skips labels that elide
/// themselves with "…" and show the full text in their tooltip.
QStringList clippedTexts(const QWidget& root);

}   // namespace angiopose::test
