#include "widgets/inputs/item_list.h"

#include "widgets/inputs/icon.h"

#include <QDropEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QToolTip>

#include <algorithm>

namespace esm {

namespace {

enum Role { NoteRole = Qt::UserRole, ColourRole, PictureRole, ShownRole };
constexpr int dotRowHeight = 27, pictureRowHeight = 54, pictureSide = 42;
constexpr int eyeWidth = 28, eyeSide = 18;
constexpr double hiddenStrength = 0.45; ///< of what a row says that is hidden

bool hasPicture(const QModelIndex& index) {
    return !index.data(PictureRole).value<QPixmap>().isNull();
}

bool hasEye(const QModelIndex& index) {
    return index.data(ShownRole).isValid();
}

bool isEyeClosed(const QModelIndex& index) {
    return hasEye(index) && !index.data(ShownRole).toBool();
}

QRect eyeOf(const QRect& row) {
    return {row.right() + 1 - eyeWidth, row.top(), eyeWidth, row.height()};
}

void paintEye(QPainter& painter, const QRect& row, bool isOpen) {
    const QRect place = eyeOf(row);
    QRect square(0, 0, eyeSide, eyeSide);
    square.moveCenter(place.center());
    icon(isOpen ? QStringLiteral("eye") : QStringLiteral("eye-closed")).paint(&painter, square);
}

class RowDelegate : public QStyledItemDelegate {
public:
    RowDelegate(QPalette::ColorRole mark, QObject* parent) : QStyledItemDelegate(parent), m_mark(mark) {}

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override {
        return {60, hasPicture(index) ? pictureRowHeight : dotRowHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRect row = option.rect;
        if (option.state & QStyle::State_Selected) paintSelection(painter, option);
        if (hasEye(index)) paintEye(*painter, row, !isEyeClosed(index));
        if (isEyeClosed(index)) painter->setOpacity(hiddenStrength);
        if (hasPicture(index))
            paintPicture(painter, option, index);
        else
            paintDot(painter, option, index);
        painter->setPen(option.palette.color(QPalette::WindowText));
        const QRect name = nameRect(row, index);
        const QString text = index.data().toString();
        painter->drawText(name, Qt::AlignVCenter | Qt::AlignLeft,
                          option.fontMetrics.elidedText(text, Qt::ElideRight, name.width()));
        painter->restore();
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
        auto* editor = new QLineEdit(parent);
        editor->setMaxLength(80);
        return editor;
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override {
        const QRect name = nameRect(option.rect, index);
        editor->setGeometry(name.x() - 8, name.center().y() - 12, option.rect.right() - name.x() + 6, 25);
    }

private:
    static int textLeft(const QRect& row, const QModelIndex& index) {
        return row.left() + (hasPicture(index) ? pictureSide + 16 : 24);
    }

    static QRect nameRect(const QRect& row, const QModelIndex& index) {
        const int left = textLeft(row, index);
        const int right = row.right() - (hasEye(index) ? eyeWidth : 0);
        if (hasPicture(index)) return {left, row.top() + 9, right - left - 6, 18};
        return {left, row.top(), right - left - 62, row.height()};
    }

    void paintSelection(QPainter* painter, const QStyleOptionViewItem& option) const {
        QColor fill = option.palette.color(m_mark);
        fill.setAlpha(38);
        const QRectF row = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
        painter->setPen(Qt::NoPen);
        painter->setBrush(fill);
        painter->drawRoundedRect(row, 5, 5);
        painter->setBrush(option.palette.color(m_mark));
        painter->drawRoundedRect(QRectF(row.left(), row.top(), 2.5, row.height()), 1.2, 1.2);
    }

    static void paintDot(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
        const QRect row = option.rect;
        painter->setPen(Qt::NoPen);
        painter->setBrush(index.data(ColourRole).value<QColor>());
        painter->drawEllipse(QPointF(row.left() + 12, row.center().y() + 0.5), 4.5, 4.5);
        painter->setPen(option.palette.color(QPalette::PlaceholderText));
        painter->drawText(row.adjusted(0, 0, -8, 0), Qt::AlignVCenter | Qt::AlignRight,
                          index.data(NoteRole).toString());
    }

    static void paintPicture(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) {
        const QRect row = option.rect;
        painter->drawPixmap(QRect(row.left() + 7, row.top() + 6, pictureSide, pictureSide),
                            index.data(PictureRole).value<QPixmap>());
        painter->setPen(option.palette.color(QPalette::PlaceholderText));
        const QRect name = nameRect(row, index);
        painter->drawText(name.translated(0, 18), Qt::AlignVCenter | Qt::AlignLeft,
                          index.data(NoteRole).toString());
    }

    QPalette::ColorRole m_mark;
};

} // namespace

int rowAfterDrop(int row, int under, DropPlace place) {
    if (place == DropPlace::On) return under;
    const int before = place == DropPlace::Below ? under + 1 : under;
    return before > row ? before - 1 : before;
}

ItemList::ItemList(QPalette::ColorRole mark, QWidget* parent) : QListWidget(parent) {
    setItemDelegate(new RowDelegate(mark, this));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setDragDropMode(QAbstractItemView::DragDrop);
    setDefaultDropAction(Qt::CopyAction);
    setFrameShape(QFrame::NoFrame);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
    connect(this, &QListWidget::currentRowChanged, this, &ItemList::rowSelected);
    connect(this, &QListWidget::itemChanged, this,
            [this](QListWidgetItem* item) { emit rowRenamed(row(item), item->text().trimmed()); });
}

void ItemList::setRows(const std::vector<ItemRow>& rows, int selected) {
    const QSignalBlocker quiet(this);
    while (count() > static_cast<int>(rows.size()))
        delete takeItem(count() - 1);
    while (count() < static_cast<int>(rows.size()))
        new QListWidgetItem(this);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QListWidgetItem* entry = item(static_cast<int>(i));
        const ItemRow& row = rows[i];
        entry->setText(row.name);
        entry->setToolTip(row.name);
        entry->setData(NoteRole, row.note);
        entry->setData(Qt::AccessibleTextRole,
                       row.note.isEmpty() ? row.name : row.name + QStringLiteral(", ") + row.note);
        entry->setData(ColourRole, row.colour);
        entry->setData(PictureRole, row.picture);
        entry->setData(ShownRole, row.isShown ? QVariant(*row.isShown) : QVariant());
        entry->setFlags(row.renamable ? entry->flags() | Qt::ItemIsEditable
                                      : entry->flags() & ~Qt::ItemIsEditable);
    }
    setCurrentRow(selected);
    if (selected < 0) clearSelection();
    doItemsLayout();
    updateGeometry();
    viewport()->update();
}

int ItemList::heightOfRows() const {
    int height = 0;
    for (int row = 0; row < count(); ++row)
        height += sizeHintForRow(row);
    return std::max(2 * dotRowHeight, height);
}

QSize ItemList::sizeHint() const {
    return {100, heightOfRows()};
}

/// Longer lists scroll, so that the sections below stay in sight.
QSize ItemList::minimumSizeHint() const {
    return {100, std::min(heightOfRows(), 8 * dotRowHeight)};
}

QRect ItemList::eyeRect(int row) const {
    const QModelIndex index = model()->index(row, 0);
    return hasEye(index) ? eyeOf(visualRect(index)) : QRect();
}

/// The row whose eye is there; -1 where none is.
int ItemList::eyeAt(const QPoint& place) const {
    const QModelIndex under = indexAt(place);
    return under.isValid() && eyeRect(under.row()).contains(place) ? under.row() : -1;
}

/// An eye neither selects its row nor begins a drag of it.
void ItemList::mousePressEvent(QMouseEvent* event) {
    const int row = event->button() == Qt::LeftButton ? eyeAt(event->pos()) : -1;
    if (row < 0) return QListWidget::mousePressEvent(event);
    emit eyeClicked(row);
}

void ItemList::mouseDoubleClickEvent(QMouseEvent* event) {
    const int row = event->button() == Qt::LeftButton ? eyeAt(event->pos()) : -1;
    if (row < 0) return QListWidget::mouseDoubleClickEvent(event);
    emit eyeClicked(row);
}

bool ItemList::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QListWidget::viewportEvent(event);
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const int row = eyeAt(help.pos());
    if (row < 0) return QListWidget::viewportEvent(event);
    QToolTip::showText(help.globalPos(), isEyeClosed(model()->index(row, 0)) ? tr("Show") : tr("Hide"),
                       viewport());
    return true;
}

void ItemList::keyPressEvent(QKeyEvent* event) {
    const int row = currentRow(), step = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down;
    if (event->key() == Qt::Key_Delete && row >= 0)
        emit removeRequested(row);
    else if (step != 0 && row >= 0 && event->modifiers().testFlag(Qt::ControlModifier))
        emit moveRequested(row, row + step);
    else
        QListWidget::keyPressEvent(event);
}

void ItemList::dragEnterEvent(QDragEnterEvent* event) {
    if (event->source() == this) QListWidget::dragEnterEvent(event);
}

void ItemList::dropEvent(QDropEvent* event) {
    if (event->source() != this || currentRow() < 0) return;
    event->acceptProposedAction();
    const QModelIndex under = indexAt(event->pos());
    const DropPlace place = dropIndicatorPosition() == BelowItem   ? DropPlace::Below
                            : dropIndicatorPosition() == AboveItem ? DropPlace::Above
                                                                   : DropPlace::On;
    const int to = under.isValid() ? rowAfterDrop(currentRow(), under.row(), place) : count() - 1;
    if (to != currentRow()) emit moveRequested(currentRow(), to);
}

void ItemList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    if (currentItem()) scrollToItem(currentItem());
}

void ItemList::paintEvent(QPaintEvent* event) {
    QListWidget::paintEvent(event);
    if (count() > 0) return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
}

} // namespace esm
