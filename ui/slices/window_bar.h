#pragma once

#include "ui/slices/slice_model.h"

#include <QWidget>

class QBoxLayout;
class QMenu;
class QPushButton;

namespace angiopose::ui {

/// Window presets of the slices, one button each; where these have no room, in a menu.
class WindowBar : public QWidget {
    Q_OBJECT
public:
    explicit WindowBar(SliceModel& model, QWidget* parent = nullptr);

    bool isFolded() const { return presets_->isHidden(); }
    QSize minimumSizeHint() const override;   ///< folded

signals:
    void closeRequested();
    void windowRequested();   ///< a window of its own, or back

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void fillPresets();
    void fold();

    SliceModel& model_;
    QWidget* presets_;
    QBoxLayout* row_;   ///< of the presets
    QPushButton* folded_;
    QMenu* menu_;
    QPushButton* ownWindow_;
    QPushButton* back_;
};

}   // namespace angiopose::ui