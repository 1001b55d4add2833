#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QPainter;
class vtkRenderWindow;

namespace angiopose::ui {

/// A VTK render window shown by a plain widget: VTK draws off screen, the widget paints the picture. A window without
/// any OpenGL widget needs no composition of its own, which costs a frame's whole time without a graphics card.
/// Redraws are asked for with requestRender() and happen once, after what the user waits for more urgently. Edges are
/// smoothed when the view comes to rest, in several short steps that any change ends: pictures moved by parts of a
/// pixel are averaged.
class VtkView : public QWidget {
    Q_OBJECT
public:
    explicit VtkView(QWidget* parent = nullptr);
    ~VtkView() override;

    void requestRender();
    vtkRenderWindow* renderWindow() const;
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    QSize deviceSize() const;   ///< in device pixels
    int renderCount() const { return renderCount_; }

protected:
    /// Called in every redraw before VTK draws: the place to bring the scene up to date.
    virtual void prepareFrame() {}
    /// Called in every redraw on top of what VTK drew, in device-independent pixels.
    virtual void paintAnnotations(QPainter& painter);

    /// Renders once, for nobody to see.
    void rehearse();

    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Glue;
    bool prepareContext();
    void drawDraft();
    void settle();
    QImage drawn(const QPointF& shiftPx);
    void paintExcuse(QPainter& painter);

    std::unique_ptr<Glue> glue_;
    QTimer renderTimer_;
    QTimer settleTimer_;
    QImage picture_;
    std::vector<QImage> passes_;   ///< of the view at rest, so far
    int renderCount_ = 0;
};

}   // namespace angiopose::ui