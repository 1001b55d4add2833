#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace angiopose::test {

/// Every visible label, button and field below the widget whose words do not fit into its room, in words. Labels that
/// shorten themselves with "…" and tell the rest in their tool tip are not meant.
QStringList clippedTexts(const QWidget& root);

}   // namespace angiopose::test