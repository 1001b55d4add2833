#pragma once

#include <QStyledItemDelegate>

namespace angiopose::ui {

/// Paints a row of the branch list (color chip, name, generation, length, auxiliary toggle, exclude toggle, residual)
/// and handles clicks on the toggles.
class BranchDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    void setEditorData(QWidget* editor, const QModelIndex& index) const override;   ///< does not overwrite typed text
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

    static QRect auxiliaryRect(const QRect& row);
    static QRect excludeRect(const QRect& row);

signals:
    void auxiliaryClicked(int branchId);
    void excludeClicked(int branchId);

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
};

}   // namespace angiopose::ui
