#pragma once

#include <QWidget>

#include <cstddef>
#include <vector>

class QGridLayout;
class QSplitter;

namespace angiopose::ui {

class AngiogramView;
class PaneTitle;
class ViewPane;

/// The shown image, and panes for further views: one beside it, more in a grid on its right.
class SideBySide : public QWidget {
    Q_OBJECT
public:
    explicit SideBySide(AngiogramView& shown, QWidget* parent = nullptr);   ///< owns it

    /// 0: the shown image alone, without its name.
    void setPaneCount(std::size_t count);
    std::size_t paneCount() const { return count_; }
    ViewPane& pane(std::size_t index) { return *panes_[index]; }
    PaneTitle& title() { return *title_; }   ///< of the shown image
    AngiogramView& shown() { return *shown_; }
    std::vector<AngiogramView*> images();   ///< the shown one first, then those of the panes

signals:
    void paneMade(ui::ViewPane* pane);   ///< once for each: what goes is kept for later

private:
    void place();

    PaneTitle* title_;
    AngiogramView* shown_;
    QWidget* others_;
    QGridLayout* grid_;
    QSplitter* halves_;
    std::vector<ViewPane*> panes_;   ///< as many as there ever were
    std::size_t count_ = 0;
};

}   // namespace angiopose::ui
