#pragma once

#include <QColor>
#include <QListWidget>
#include <QPixmap>

#include <optional>
#include <vector>

namespace esm {

/// A row of an ItemList: a dot of its own colour or a small picture, a name, and a quiet note.
struct ItemRow {
    QString name;
    QString note;    ///< at the right of a dot's row, beneath the name of a picture's row
    QColor colour;   ///< of the dot
    QPixmap picture; ///< in place of the dot
    bool renamable = true;
    std::optional<bool> isShown{}; ///< has an eye, open or closed
};

/// Where a row lands that is dropped on, above or below another.
enum class DropPlace { On, Above, Below };
/// The place that the dropped row gets, once it is taken out of its own.
int rowAfterDrop(int row, int under, DropPlace place);

/// A list of named things, one of which is selected; a double click or F2 renames, Delete asks for removal, a
/// drag or Ctrl with the arrow keys asks for another order. It is as high as its rows where there is room,
/// and scrolls where there is not.
class ItemList : public QListWidget {
    Q_OBJECT

public:
    /// @param mark colour of the selected row's edge
    explicit ItemList(QPalette::ColorRole mark, QWidget* parent = nullptr);

    /// Shows rows, announcing nothing. `selected` below zero selects none.
    void setRows(const std::vector<ItemRow>& rows, int selected);
    /// What stands in the list while it is empty.
    void setEmptyText(const QString& text) { m_emptyText = text; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Where a row's eye is, in the viewport; empty where it has none.
    QRect eyeRect(int row) const;

signals:
    void rowSelected(int row);
    void rowRenamed(int row, const QString& name);
    void removeRequested(int row);
    /// The row's eye was clicked: what is shown is to be hidden, and the other way round.
    void eyeClicked(int row);
    /// Nothing has moved yet.
    void moveRequested(int row, int to);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    /// Who owns the rows moves them, and shows them anew: of a row that is moved the list would take the old
    /// one away itself.
    Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int eyeAt(const QPoint& place) const;
    int heightOfRows() const;

    QString m_emptyText;
};

} // namespace esm
