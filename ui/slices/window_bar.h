#pragma once

#include "ui/slices/slice_model.h"

#include <QWidget>

class QBoxLayout;
class QMenu;
class QPushButton;

namespace angiopose::ui {

/// Bar with the window presets of the slices: buttons, or a menu where space is short.
class WindowBar : public QWidget {
    Q_OBJECT
public:
    explicit WindowBar(SliceModel& model, QWidget* parent = nullptr);

    bool isFolded() const { return presets_->isHidden(); }
    QSize minimumSizeHint() const override;   ///< size with the menu instead of the buttons

signals:
    void closeRequested();
    void popOutRequested();   ///< requests popping out the slices, or docking them

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void fillPresets();
    void collapse();

    SliceModel& model_;
    QWidget* presets_;
    QBoxLayout* row_;   ///< layout of the preset buttons
    QPushButton* menuButton_;
    QMenu* menu_;
    QPushButton* popOut_;
    QPushButton* back_;
};

}   // namespace angiopose::ui
