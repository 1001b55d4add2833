#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QPainter;
class vtkRenderWindow;

namespace angiopose::ui {

/// VTK view in a plain widget: VTK renders off screen, and the widget paints the image. A window without OpenGL widgets
/// needs no composition, which takes as long as a whole frame without a graphics card. requestRender() schedules a
/// single rendering after more urgent work. When the view comes to rest, it smooths edges by averaging renderings with
/// subpixel offsets, in several short steps that any change interrupts.
class VtkView : public QWidget {
    Q_OBJECT
public:
    explicit VtkView(QWidget* parent = nullptr);
    ~VtkView() override;

    void requestRender();
    vtkRenderWindow* renderWindow() const;
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    QSize deviceSize() const;   ///< size in device pixels
    int renderCount() const { return renderCount_; }

protected:
    /// Called before VTK renders; updates the scene.
    virtual void prepareFrame() {}
    /// Called after VTK has rendered; paints on top in device-independent pixels.
    virtual void paintAnnotations(QPainter& painter);

    /// Renders once without showing the result.
    void renderHidden();

    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct VtkResources;
    bool prepareContext();
    void drawDraft();
    void settle();
    QImage drawn(const QPointF& shiftPx);
    void paintError(QPainter& painter);

    std::unique_ptr<VtkResources> vtk_;
    QTimer renderTimer_;
    QTimer settleTimer_;
    QImage image_;
    std::vector<QImage> samples_;   ///< renderings with offsets completed since the view came to rest
    int renderCount_ = 0;
};

}   // namespace angiopose::ui
