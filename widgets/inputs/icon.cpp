#include "widgets/inputs/icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

// Resources of a static library are only linked in when asked for; the macro must stand outside any
// namespace.
static void initializeResources() {
    Q_INIT_RESOURCE(esm);
}

namespace esm {

namespace {

QByteArray svgSource(const QString& name) {
    initializeResources();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QColor strokeColour(QIcon::Mode mode, QIcon::State state) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (state == QIcon::On) return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::WindowText);
}

/// Draws with the palette's colours at the time of drawing: a change of theme needs no new icons.
class LineIconEngine : public QIconEngine {
public:
    explicit LineIconEngine(QByteArray source) : m_source(std::move(source)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        QByteArray coloured = m_source;
        coloured.replace("currentColor", strokeColour(mode, state).name().toLatin1());
        QSvgRenderer(coloured).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect({0, 0}, size), mode, state);
        return picture;
    }

    QIconEngine* clone() const override { return new LineIconEngine(m_source); }

private:
    QByteArray m_source;
};

} // namespace

void loadResources() {
    initializeResources();
}

QIcon icon(const QString& name) {
    return QIcon(new LineIconEngine(svgSource(name)));
}

} // namespace esm
