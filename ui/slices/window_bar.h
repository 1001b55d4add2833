#pragma once

#include "ui/slices/slice_model.h"

#include <QWidget>

class QBoxLayout;
class QMenu;
class QPushButton;

namespace angiopose::ui {

/// Window presets of the slices as buttons, or as a menu if there is no room.
class WindowBar : public QWidget {
    Q_OBJECT
public:
    explicit WindowBar(SliceModel& model, QWidget* parent = nullptr);

    bool isFolded() const { return presets_->isHidden(); }
    QSize minimumSizeHint() const override;   ///< size of the menu form

signals:
    void closeRequested();
    void windowRequested();   ///< toggle the pop-out window

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void fillPresets();
    void fold();

    SliceModel& model_;
    QWidget* presets_;
    QBoxLayout* row_;   ///< preset buttons
    QPushButton* folded_;
    QMenu* menu_;
    QPushButton* ownWindow_;
    QPushButton* back_;
};

}   // namespace angiopose::ui