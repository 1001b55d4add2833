#pragma once

class QDialog;
class QHBoxLayout;
class QPushButton;
class QString;

namespace angiopose::ui {

/// The row below a dialog: what rejects it, and the primary button that accepts it, by Enter too.
QHBoxLayout* dialogButtons(QDialog& dialog, const QString& cancel, QPushButton& accept);

}   // namespace angiopose::ui
