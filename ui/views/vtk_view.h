#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QPainter;
class vtkRenderWindow;

namespace angiopose::ui {

/// VTK render window shown by a plain widget: VTK draws off screen, the widget paints the image. A window without an
/// OpenGL widget needs no composition, which takes as long as a whole frame without a graphics card. requestRender()
/// schedules a rendering that runs once, after more urgent work. Edges are smoothed when the view comes to rest, by
/// averaging renderings with subpixel offsets in several short steps that any change interrupts.
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
    /// Called before VTK draws, to update the scene.
    virtual void prepareFrame() {}
    /// Called after VTK draws, to paint on top in device-independent pixels.
    virtual void paintAnnotations(QPainter& painter);

    /// Renders once without showing the result.
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
    std::vector<QImage> passes_;   ///< renderings at rest so far
    int renderCount_ = 0;
};

}   // namespace angiopose::ui