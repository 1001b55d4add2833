#pragma once

class QDialog;
class QHBoxLayout;
class QPushButton;
class QString;

namespace angiopose::ui {

/// Creates the button row of a dialog: Cancel, and `accept` as the default button (also triggered by Enter).
QHBoxLayout* dialogButtons(QDialog& dialog, const QString& cancel, QPushButton& accept);

}   // namespace angiopose::ui
